// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"
#include "render/image.h"

#include <array>
#include <string>
#include <string_view>

namespace bedmix {

/// Keys the panel knows, beside the text that typing makes.
enum class PanelKey {
  left,
  right,
  up,
  down,
  pageUp,
  pageDown,
  home,
  end,
  remove,
  backspace,
  space,
  enter,
  escape,
  tab,
  shift,
  control,
  alt
};
/// Their names, in that order: those of the browser's KeyboardEvent.key.
inline constexpr std::array<std::string_view, 17> panelKeyNames{
    "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home",    "End", "Delete",
    "Backspace", " ",          "Enter",   "Escape",    "Tab",    "Shift",    "Control", "Alt"};

/// Something a person did, in a browser, or a script in their place. Places are pixels of the picture.
struct InputEvent {
  enum class Kind { pointer, wheel, key, text, size, leave };

  Kind kind = Kind::pointer;
  Vec2f at = {};                  // pointer and wheel
  unsigned buttons = 0;           // pointer: those down from now on: 1 left, 2 right, 4 middle
  bool isTouch = false;           // pointer: a finger, which cannot hover
  Vec2f turn = {};                // wheel: notches to the right and up
  PanelKey key = PanelKey::left;  // key
  bool isDown = false;            // key
  std::string text = {};          // text: UTF-8, at most 64 bytes
  Size size = {};                 // size: of the picture from now on
  float scale = 1.0f;             // size: pixels of the picture per pixel that texts are laid out in

  bool operator==(const InputEvent&) const = default;
};

}  // namespace bedmix
