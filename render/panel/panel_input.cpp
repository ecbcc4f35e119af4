// SPDX-License-Identifier: MIT
#include "render/panel/panel_input.h"

#include <imgui.h>

#include <cfloat>
#include <utility>

namespace bedmix {

namespace {

constexpr std::pair<ImGuiKey_, PanelKey> keys[] = {
    {ImGuiKey_LeftArrow, PanelKey::left}, {ImGuiKey_RightArrow, PanelKey::right},
    {ImGuiKey_UpArrow, PanelKey::up},     {ImGuiKey_DownArrow, PanelKey::down},
    {ImGuiKey_PageUp, PanelKey::pageUp},  {ImGuiKey_PageDown, PanelKey::pageDown},
    {ImGuiKey_Home, PanelKey::home},      {ImGuiKey_End, PanelKey::end},
    {ImGuiKey_Delete, PanelKey::remove},  {ImGuiKey_Backspace, PanelKey::backspace},
    {ImGuiKey_Space, PanelKey::space},    {ImGuiKey_Enter, PanelKey::enter},
    {ImGuiKey_Escape, PanelKey::escape},  {ImGuiKey_Tab, PanelKey::tab}};

void setKey(ImGuiIO& io, PanelKey key, bool isDown) {
  switch (key) {
    case PanelKey::shift:
      io.KeyShift = isDown;
      break;
    case PanelKey::control:
      io.KeyCtrl = isDown;
      break;
    case PanelKey::alt:
      io.KeyAlt = isDown;
      break;
    default:
      io.KeysDown[static_cast<int>(key)] = isDown;
  }
}

}  // namespace

void PanelInput::mapKeys() {
  for (const auto& [theirs, ours] : keys) ImGui::GetIO().KeyMap[theirs] = static_cast<int>(ours);
}

std::span<const InputEvent> PanelInput::take(std::span<const InputEvent> events) {
  ImGuiIO& io = ImGui::GetIO();
  if (std::exchange(liftsAway_, false)) io.MousePos = {-FLT_MAX, -FLT_MAX};
  bool pressed = false, typed = false;
  for (; !events.empty(); events = events.subspan(1)) {
    const InputEvent& event = events.front();
    switch (event.kind) {
      case InputEvent::Kind::pointer:
        // A press counts where it was made.
        if (pressed) return events;
        pressed = event.buttons != buttons_;
        if (pressed && !(at_ == event.at)) {
          at_ = event.at;  // it came there first
          io.MousePos = {at_.x, at_.y};
          return events;
        }
        at_ = event.at;
        isTouch_ = event.isTouch;
        liftsAway_ = event.isTouch && event.buttons == 0;
        buttons_ = event.buttons;
        io.MousePos = {event.at.x, event.at.y};
        for (unsigned i = 0; i < 3; ++i) io.MouseDown[i] = (buttons_ >> i & 1u) != 0;
        break;
      case InputEvent::Kind::wheel:
        io.MouseWheelH += event.turn.x;
        io.MouseWheel += event.turn.y;
        break;
      case InputEvent::Kind::key:
        if (typed) return events;
        typed = true;
        setKey(io, event.key, event.isDown);
        break;
      case InputEvent::Kind::text:
        if (typed) return events;
        io.AddInputCharactersUTF8(event.text.c_str());
        break;
      case InputEvent::Kind::leave:
        if (pressed) return events;
        pressed = buttons_ != 0;
        buttons_ = 0;
        io.MousePos = {-FLT_MAX, -FLT_MAX};
        for (bool& down : io.MouseDown) down = false;
        for (bool& down : io.KeysDown) down = false;
        io.KeyShift = io.KeyCtrl = io.KeyAlt = false;
        break;
      case InputEvent::Kind::size:
        break;  // whoever draws the picture makes another panel
    }
  }
  return events;
}

}  // namespace bedmix
