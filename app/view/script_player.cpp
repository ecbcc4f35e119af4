// SPDX-License-Identifier: MIT
#include "app/view/script_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

constexpr int dragPictures = 6;   // from press to release
constexpr int mostScrolls = 200;  // pictures, to bring something into view

InputEvent pointerAt(Vec2f at, unsigned buttons, bool isTouch) {
  return {.kind = InputEvent::Kind::pointer, .at = at, .buttons = buttons, .isTouch = isTouch};
}

InputEvent keyEvent(PanelKey key, bool isDown) {
  return {.kind = InputEvent::Kind::key, .key = key, .isDown = isDown};
}

}  // namespace

bool ScriptPlayer::atEnd() const {
  const bool isLate = nextStep_ < script_.steps.size() && script_.steps[nextStep_].at <= script_.until + 1e-9;
  return static_cast<double>(pictures_) / script_.fps > script_.until + 1e-9 && waiting_.empty() && !isLate;
}

Result<Vec2f> ScriptPlayer::placeOf(const ScriptPlace& place, float share, const ScriptStep& step,
                                    const ViewSession& session) const {
  if (const auto* at = std::get_if<Vec2f>(&place)) return *at;
  const std::string& label = std::get<std::string>(place);
  const std::optional<Box> box = session.panel().item(label);
  if (!box)
    return Diagnostic{{script_.file, step.line, 1},
                      fmt::format("the panel has no \"{}\" then; is the section it is in closed?", label)};
  return Vec2f{box->left + share * box->width(), 0.5f * (box->top + box->bottom)};
}

/// Whether the item has to be brought into view, which then goes on.
bool ScriptPlayer::scrollTo(const ScriptStep& step, const ViewSession& session) {
  const bool points = step.kind == ScriptStep::Kind::click || step.kind == ScriptStep::Kind::drag;
  const auto* label = std::get_if<std::string>(&step.place);
  if (!points || !label || scrolls_ >= mostScrolls) return false;
  const std::optional<Box> item = session.panel().item(*label);
  if (!item) return false;
  const Box part = session.panel().panelPart();
  if (item->top >= part.top && item->bottom <= part.bottom) return false;
  ++scrolls_;
  const Vec2f over{0.5f * (part.left + part.right), 0.5f * (part.top + part.bottom)};
  waiting_.push_back(
      {pointerAt(over, 0, false),
       {.kind = InputEvent::Kind::wheel, .at = over, .turn = {0.0f, item->top < part.top ? 0.5f : -0.5f}}});
  return true;
}

/// What happens in each of the next pictures.
Result<std::vector<ScriptPlayer::Events>> ScriptPlayer::eventsOf(const ScriptStep& step,
                                                                 const ViewSession& session) {
  switch (step.kind) {
    case ScriptStep::Kind::key:
      return std::vector<Events>{{keyEvent(step.key, true)}, {keyEvent(step.key, false)}};
    case ScriptStep::Kind::type:
      return std::vector<Events>{{{.kind = InputEvent::Kind::text, .text = step.text}}};
    case ScriptStep::Kind::resize:
      return std::vector<Events>{{{.kind = InputEvent::Kind::size, .size = step.size, .scale = step.scale}}};
    default:
      break;
  }
  const auto at = placeOf(step.place, 0.5f, step, session);
  if (!at) return at.problems;
  if (step.kind == ScriptStep::Kind::wheel)
    return std::vector<Events>{
        {pointerAt(*at, 0, false), {.kind = InputEvent::Kind::wheel, .at = *at, .turn = step.turn}}};
  if (step.kind == ScriptStep::Kind::click)
    return std::vector<Events>{{pointerAt(*at, 0, step.isTouch)},
                               {pointerAt(*at, 1, step.isTouch)},
                               {pointerAt(*at, 0, step.isTouch)}};
  const bool byShare = std::get_if<std::string>(&step.place) && std::get_if<Vec2f>(&step.target) &&
                       std::get<Vec2f>(step.target) == Vec2f{};
  const auto to =
      byShare ? placeOf(step.place, step.share, step, session) : placeOf(step.target, 0.5f, step, session);
  if (!to) return to.problems;
  std::vector<Events> drag{{pointerAt(*at, 0, step.isTouch)}, {pointerAt(*at, 1, step.isTouch)}};
  for (int k = 1; k <= dragPictures; ++k) {
    const float part = static_cast<float>(k) / dragPictures;
    drag.push_back(
        {pointerAt({at->x + part * (to->x - at->x), at->y + part * (to->y - at->y)}, 1, step.isTouch)});
  }
  drag.push_back({pointerAt(*to, 0, step.isTouch)});
  return drag;
}

Result<Done> ScriptPlayer::next(ViewSession& session, Image& image) {
  const double now = static_cast<double>(pictures_) / script_.fps;
  while (waiting_.empty() && nextStep_ < script_.steps.size() && pictures_ > 0 &&
         script_.steps[nextStep_].at <= now + 1e-9) {
    const ScriptStep& step = script_.steps[nextStep_];
    if (scrollTo(step, session)) break;
    auto events = eventsOf(step, session);
    if (!events) return events.problems;
    for (Events& each : *events) waiting_.push_back(std::move(each));
    scrolls_ = 0;
    ++nextStep_;
  }
  Events events;
  if (!waiting_.empty()) {
    events = std::move(waiting_.front());
    waiting_.pop_front();
  }
  session.draw(events, pictures_ > 0 ? 1.0 / script_.fps : 0.0, image);
  ++pictures_;
  return Done{};
}

}  // namespace bedmix
