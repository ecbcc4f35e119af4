// SPDX-License-Identifier: MIT
#pragma once

#include "render/panel/panel_action.h"
#include "render/panel/panel_model.h"

#include <optional>
#include <string_view>
#include <vector>

namespace bedmix {

/// What the pointer does on the beds themselves: it picks particles, and drags the lines of the sampling
/// cells.
class BedPointer {
 public:
  struct Pointer {
    Vec2f at;                                // px
    bool isPressed = false, isDown = false;  // just now; still
    float reach = 5.0f;                      // px, how near is near
  };

  void update(const PanelModel& model, const Pointer& pointer, std::vector<PanelAction>& actions);
  /// CSS name of the shape that says what can be done there; empty for the usual.
  std::string_view cursor() const { return cursor_; }

 private:
  /// The n-th of a bed's lines between columns, or between rows.
  struct GridLine {
    std::size_t bed = 0;
    bool isUpright = true;
    int n = 1;
  };
  std::optional<GridLine> lineAt(const PanelModel& model, const Pointer& pointer) const;
  void drag(const PanelModel& model, const Pointer& pointer, std::vector<PanelAction>& actions) const;

  std::optional<GridLine> dragged_;
  std::string_view cursor_;
};

}  // namespace bedmix
