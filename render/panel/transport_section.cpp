// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double slowest = 0.01, fastest = 100.0;  // simulated s per wall s, of the slider
constexpr double unlimited = fastest * 1.01;       // its right end in a live run

/// A slider whose right end stands for 0: as fast as it goes.
void speedSlider(const PanelModel& model, PanelActions& actions) {
  const double end = model.isLive ? unlimited : fastest;
  double speed = model.speed > 0.0 ? model.speed : end;
  const std::string shown = model.speed > 0.0 ? "%.3g x real time" : "as fast as it goes";
  if (slider("speed", &speed, slowest, end, shown.c_str(),
             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
    actions.push_back({PanelAction::Speed{model.isLive && speed > fastest ? 0.0 : speed}});
  explain("Simulated seconds per second of the wall clock");
}

void playButton(const PanelModel& model, PanelActions& actions) {
  const float width = 5.5f * ImGui::GetFontSize();
  if (button(model.isPlaying ? "Pause###play" : "Play###play", {width, 0.0f}))
    actions.push_back({PanelAction::Play{!model.isPlaying}});
}

void liveButtons(const PanelModel& model, PanelActions& actions) {
  playButton(model, actions);
  ImGui::SameLine();
  if (button("Step")) actions.push_back({PanelAction::Step{}});
  explain("One sampling interval, then pause");
  ImGui::SameLine();
  if (button("Restart")) actions.push_back({PanelAction::Restart{}});
  explain("From 0 s, with the values as they are now");
}

/// Lines of the key times on the slider that was drawn last.
void drawKeyTimes(const PanelModel& model) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  for (const double time : model.keyTimes) {
    const double share = (time - model.begin) / std::max(model.end - model.begin, 1e-12);
    const float x = low.x + static_cast<float>(share) * (high.x - low.x);
    ImGui::GetWindowDrawList()->AddLine({x, low.y}, {x, high.y}, packed({230, 159, 0}), 2.0f);
  }
}

/// The key time next to the present one, before or after it; the run's end where there is none.
double nextKeyTime(const PanelModel& model, bool after) {
  double next = after ? model.end : model.begin;
  for (const double time : model.keyTimes) {
    if (after && time > model.time + 1e-9) next = std::min(next, time);
    if (!after && time < model.time - 1e-9) next = std::max(next, time);
  }
  return next;
}

void recordedButtons(const PanelModel& model, PanelActions& actions) {
  const auto key = [](ImGuiKey_ name) {
    return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(name));
  };
  playButton(model, actions);
  ImGui::SameLine();
  if (button("<") || key(ImGuiKey_LeftArrow)) actions.push_back({PanelAction::Step{-1}});
  ImGui::SameLine();
  if (button(">") || key(ImGuiKey_RightArrow)) actions.push_back({PanelAction::Step{1}});
  ImGui::SameLine();
  if (button("Mark")) actions.push_back({PanelAction::Mark{}});
  explain("Marks this time on the slider; again: takes the mark away. Page up and down go from mark to mark");
  ImGui::SameLine();
  bool loops = model.loops;
  if (checkBox("Loop", &loops)) actions.push_back({PanelAction::Loop{loops}});
  if (key(ImGuiKey_PageUp)) actions.push_back({PanelAction::Seek{nextKeyTime(model, false)}});
  if (key(ImGuiKey_PageDown)) actions.push_back({PanelAction::Seek{nextKeyTime(model, true)}});
  if (key(ImGuiKey_Home)) actions.push_back({PanelAction::Seek{model.begin}});
  if (key(ImGuiKey_End)) actions.push_back({PanelAction::Seek{model.end}});

  double time = model.time;
  if (slider("time", &time, model.begin, model.end, "%.4g s", ImGuiSliderFlags_AlwaysClamp))
    actions.push_back({PanelAction::Seek{time}});
  drawKeyTimes(model);
}

}  // namespace

void transportSection(const PanelModel& model, PanelActions& actions) {
  ImGui::PushTextWrapPos(0.0f);
  text(model.title);
  ImGui::PopTextWrapPos();
  if (model.isLive)
    liveButtons(model, actions);
  else
    recordedButtons(model, actions);
  if (!ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Space)) &&
      !ImGui::IsAnyItemActive())
    actions.push_back({PanelAction::Play{!model.isPlaying}});
  speedSlider(model, actions);
  if (model.isLive)
    text(fmt::format("t = {:.2f} s{}", model.time,
                     model.reached > 0.0 ? fmt::format(", {:.2g} x real time", model.reached) : ""));
  else
    text(fmt::format("frame {} of {}", model.frame + 1, model.frames));
  if (!model.trouble.empty()) troubleText(model.trouble);
  if (!model.notice.empty())
    troubleText(model.notice);
  else if (model.trouble.empty())
    ImGui::NewLine();  // so that a line that comes and goes moves nothing
}

}  // namespace bedmix
