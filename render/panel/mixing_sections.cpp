// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

void samplingSection(const PanelModel& model, PanelActions& actions) {
  if (!section("Sampling cells")) return;
  int columns = model.grid.columns, rows = model.grid.rows, fewest = model.grid.minParticles;
  bool moved = false;
  moved |= slider("columns", &columns, 1, 40);
  moved |= slider("rows", &rows, 1, 100);
  moved |= slider("min particles", &fewest, 1, 100);
  if (moved) actions.push_back({PanelAction::Resample{columns, rows, fewest}});
  text("The lines of the layer sampling can be dragged");
  if (model.indicesDone < 1.0)
    ImGui::ProgressBar(static_cast<float>(model.indicesDone), {-1.0f, ImGui::GetFontSize()},
                       "indices of all frames");
}

void tracerSection(const PanelModel& model, PanelActions& actions) {
  if (!section("Tracer")) return;
  text(fmt::format("Tagged anew where the particles are at {:.4g} s:", model.time));
  for (std::size_t i = 0; i < modelTable<TracerRule>.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine();
    if (button(std::string(modelTable<TracerRule>[i].name), {8.0f * ImGui::GetFontSize(), 0.0f}))
      actions.push_back({PanelAction::Tag{static_cast<TracerRule>(i)}});
  }
}

void particleSection(const PanelModel& model, PanelActions& actions) {
  if (!model.picked) return;
  if (!section("Particle", ImGuiTreeNodeFlags_DefaultOpen)) return;
  factTable("particle", model.particle);
  if (button("Let go")) actions.push_back({PanelAction::Pick{}});
}

void numbersSection(const PanelModel& model, PanelActions&) {
  if (model.numbers.empty() && model.stages.empty()) return;
  if (!section("Solver")) return;
  factTable("stages", model.stages);
  factTable("numbers", model.numbers);
}

void savingSection(const PanelModel& model, PanelActions& actions) {
  if (!section("Save")) return;
  if (model.canRecord && !model.isRecording) {
    if (button("Record")) actions.push_back({PanelAction::Record{}});
    explain("Trajectory and series, from the present frame on");
    ImGui::SameLine();
    if (button("Record and film")) actions.push_back({PanelAction::Record{true}});
  }
  if (model.isRecording) {
    if (button("Stop recording")) actions.push_back({PanelAction::StopRecording{}});
    text("recording into " + model.recording);
  }
  if (button("Save picture")) actions.push_back({PanelAction::SavePicture{}});
  if (model.isLive) {
    ImGui::SameLine();
    if (button("Save scene")) actions.push_back({PanelAction::SaveScene{}});
    explain("As it is steered now, as TOML");
  }
  for (const std::string& name : model.saved) text(name);
}

}  // namespace bedmix
