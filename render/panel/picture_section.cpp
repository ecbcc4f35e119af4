// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <string>

namespace bedmix {

namespace {

void layerBoxes(const PanelModel& model, PanelActions& actions) {
  if (!ImGui::BeginTable("layers", 2)) return;
  for (std::size_t i = 0; i < modelTable<Layer>.size(); ++i) {
    const auto layer = static_cast<Layer>(i);
    if (layer == Layer::trails || layer == Layer::curve) continue;  // the panel has its own
    ImGui::TableNextColumn();
    bool shown = model.style.layers.has(layer);
    const std::string& why = model.missing[i];
    beginLocked(why);
    if (checkBox(std::string(modelTable<Layer>[i].name), &shown)) {
      Style style = model.style;
      style.layers = {};
      for (std::size_t k = 0; k < modelTable<Layer>.size(); ++k) {
        const auto other = static_cast<Layer>(k);
        const bool gives = isField(layer) && isField(other) && shown;  // only one field at a time
        if (other == layer ? shown : model.style.layers.has(other) && !gives) style.layers.add(other);
      }
      actions.push_back({PanelAction::Restyle{style}});
    }
    if (why.empty()) explain(modelTable<Layer>[i].formula);
    endLocked(why);
  }
  ImGui::EndTable();
}

void colorChoice(const PanelModel& model, PanelActions& actions) {
  const auto name = [](ParticleColor color) { return std::string(modelName(color)); };
  ImGui::SetNextItemWidth(-5.0f * ImGui::GetFontSize());
  if (ImGui::BeginCombo("colour", name(model.style.color).c_str())) {
    for (std::size_t i = 0; i < modelTable<ParticleColor>.size(); ++i) {
      const auto color = static_cast<ParticleColor>(i);
      const std::string_view why = color == ParticleColor::spin ? model.colorMissing : std::string_view();
      beginLocked(why);
      if (ImGui::Selectable(name(color).c_str(), color == model.style.color)) {
        Style style = model.style;
        style.color = color;
        actions.push_back({PanelAction::Restyle{style}});
      }
      endLocked(why);
    }
    ImGui::EndCombo();
  }
  if (!hasClasses(model.style.color)) return;
  int classes = static_cast<int>(model.style.classes);
  if (slider("classes", &classes, 1, 12)) {
    Style style = model.style;
    style.classes = classes;
    actions.push_back({PanelAction::Restyle{style}});
  }
}

}  // namespace

void pictureSection(const PanelModel& model, PanelActions& actions) {
  if (!section("Picture", ImGuiTreeNodeFlags_DefaultOpen)) return;
  layerBoxes(model, actions);
  colorChoice(model, actions);
  bool dark = model.style.ground == black;
  if (checkBox("dark background", &dark)) {
    Style style = model.style;
    style.ground = dark ? black : white;
    actions.push_back({PanelAction::Restyle{style}});
  }
}

}  // namespace bedmix
