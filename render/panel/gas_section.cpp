// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

namespace bedmix {

void gasSection(const PanelModel& model, PanelActions& actions) {
  if (model.inlets.empty() || !section("Gas", ImGuiTreeNodeFlags_DefaultOpen)) return;
  bool on = model.isGasOn;
  if (checkBox("Distributor on", &on)) actions.push_back({PanelAction::GasOn{on}});
  ImGui::BeginDisabled(!on);
  for (std::size_t i = 0; i < model.inlets.size(); ++i) {
    const PanelInlet& inlet = model.inlets[i];
    text(fmt::format("inlet {}, {:.2f} u_mf", inlet.name, inlet.inUmf));
    double velocity = inlet.velocity;
    if (slider(fmt::format("velocity {}", i + 1), &velocity, 0.0, model.fastestInlet, "%.3f m/s"))
      actions.push_back({PanelAction::Change{
          {{fmt::format("gas.inlets.{}.velocity_umf", i), ""},
           {fmt::format("gas.inlets.{}.velocity", i), fmt::format("{:.6g}", velocity)}}}});
    explain("Superficial velocity; Ctrl and a click lets you type it");
  }
  ImGui::EndDisabled();
}

}  // namespace bedmix
