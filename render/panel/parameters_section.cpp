// SPDX-License-Identifier: MIT
#include "engine/core/scene_keys.h"
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

namespace bedmix {

namespace {

std::string meaning(const Key& key) {
  const std::string range = rangeText(key);
  return fmt::format("{}{}{}", key.meaning, range.empty() ? "" : "\n", range);
}

void change(const PanelParameter& parameter, std::string value, PanelActions& actions) {
  actions.push_back({PanelAction::Change{{{parameter.value.path, std::move(value)}}}});
}

void choice(const PanelParameter& parameter, PanelActions& actions) {
  if (!ImGui::BeginCombo("##value", parameter.value.text.c_str())) return;
  for (const std::string_view name : parameter.value.choices)
    if (ImGui::Selectable(std::string(name).c_str()))
      change(parameter, tomlString(std::string(name)), actions);
  ImGui::EndCombo();
}

void number(const PanelParameter& parameter, PanelActions& actions) {
  double value = *parameter.value.number;
  const bool isWhole = parameter.value.text.find_first_of(".en") == std::string::npos;
  ImGui::InputDouble("##value", &value, 0.0, 0.0, isWhole ? "%.0f" : "%.6g",
                     ImGuiInputTextFlags_AutoSelectAll);
  noteItem(parameter.value.path);
  if (ImGui::IsItemDeactivatedAfterEdit())
    change(parameter, isWhole ? fmt::format("{:.0f}", value) : tomlNumber(value), actions);
}

void row(const PanelParameter& parameter, PanelActions& actions) {
  const SceneValue& value = parameter.value;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  text(value.key.unit.empty() ? std::string(value.key.name)
                              : fmt::format("{}, {}", value.key.name, value.key.unit));
  explain(meaning(value.key));
  ImGui::TableNextColumn();
  ImGui::PushID(value.path.c_str());
  ImGui::SetNextItemWidth(-1.0f);
  beginLocked(parameter.fixed);
  if (!value.choices.empty())
    choice(parameter, actions);
  else if (value.number)
    number(parameter, actions);
  else
    text(value.text);
  endLocked(parameter.fixed);
  ImGui::PopID();
}

/// The table a key is in: "gas.inlets.0" of "gas.inlets.0.velocity".
std::string_view tableOf(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

}  // namespace

void parametersSection(const PanelModel& model, PanelActions& actions) {
  if (model.parameters.empty() || !section("All parameters")) return;
  const std::vector<PanelParameter>& all = model.parameters;
  for (std::size_t first = 0; first < all.size();) {
    const std::string_view table = tableOf(all[first].value.path);
    std::size_t last = first;
    while (last < all.size() && tableOf(all[last].value.path) == table) ++last;
    const std::string name = table.empty() ? "scene" : std::string(table);
    const bool isOpen = ImGui::TreeNode(name.c_str());
    noteItem(name);
    if (isOpen) {
      if (ImGui::BeginTable("keys", 2)) {
        for (std::size_t i = first; i < last; ++i) row(all[i], actions);
        ImGui::EndTable();
      }
      ImGui::TreePop();
    }
    first = last;
  }
}

}  // namespace bedmix
