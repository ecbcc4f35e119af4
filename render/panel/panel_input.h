// SPDX-License-Identifier: MIT
#pragma once

#include "render/panel/input_event.h"

#include <span>

namespace bedmix {

/// Hands input to Dear ImGui, whose context's turn it must be. ImGui 1.86 sees only the state of each of its
/// frames: what would hide something else, as a release does its press, has to wait for the next.
class PanelInput {
 public:
  /// Once, before the first frame.
  static void mapKeys();
  /// Takes the events that fit into the next frame; the rest.
  std::span<const InputEvent> take(std::span<const InputEvent> events);

  /// Whether the pointer is a finger.
  bool isTouch() const { return isTouch_; }

 private:
  unsigned buttons_ = 0;
  Vec2f at_;  // where the pointer was last
  bool isTouch_ = false, liftsAway_ = false;
};

}  // namespace bedmix
