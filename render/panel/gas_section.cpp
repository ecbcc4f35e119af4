// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

namespace bedmix {

void gasSection(const PanelModel& model, PanelActions& actions) {
  if (model.inlets.empty() || !ImGui::CollapsingHeader("Gas", ImGuiTreeNodeFlags_DefaultOpen)) return;
  bool on = model.isGasOn;
  if (ImGui::Checkbox("Distributor on", &on)) actions.push_back({PanelAction::GasOn{on}});
  ImGui::BeginDisabled(!on);
  for (std::size_t i = 0; i < model.inlets.size(); ++i) {
    const PanelInlet& inlet = model.inlets[i];
    ImGui::PushID(static_cast<int>(i));
    text(fmt::format("inlet {}, {:.2f} u_mf", inlet.name, inlet.inUmf));
    double velocity = inlet.velocity;
    const double none = 0.0;
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::SliderScalar("##velocity", ImGuiDataType_Double, &velocity, &none, &model.fastestInlet,
                            "%.3f m/s"))
      actions.push_back({PanelAction::Change{
          {{fmt::format("gas.inlets.{}.velocity_umf", i), ""},
           {fmt::format("gas.inlets.{}.velocity", i), fmt::format("{:.6g}", velocity)}}}});
    explain("Superficial velocity; a double click, or Ctrl and a click, lets you type it");
    ImGui::PopID();
  }
  ImGui::EndDisabled();
}

}  // namespace bedmix
