// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/vec2.h"
#include "render/image.h"
#include "render/panel/input_event.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bedmix {

/// A place in the picture, px, or the label of something in the panel.
using ScriptPlace = std::variant<Vec2f, std::string>;

/// One thing a script does.
struct ScriptStep {
  enum class Kind { click, drag, wheel, key, type, resize };

  double at = 0.0;  // s of the script's clock; the steps before it are done first
  Kind kind = Kind::click;
  ScriptPlace place;   // click, drag, wheel
  ScriptPlace target;  // drag: to a place,
  float share = 0.0f;  // or, where `place` is a label, to this share of its width
  bool isTouch = false;
  Vec2f turn;          // wheel, notches
  PanelKey key{};      // pressed and let go
  std::string text;    // type
  Size size;           // resize
  float scale = 1.0f;  // resize
  int line = 0;        // of the script, for messages
};

/// What a person would do in the browser, from a TOML file (see assets/docs/view.md).
struct ViewScript {
  std::string file;
  Size size{1280, 720};
  float scale = 1.0f;
  double fps = 30.0;   // pictures a second of its clock; a live run that plays goes on by one frame in each
  double until = 0.0;  // s
  std::vector<ScriptStep> steps;
};

/// Reads a script; all that is wrong with it, each with file:line:column.
Result<ViewScript> readViewScript(const std::string& path);

}  // namespace bedmix
