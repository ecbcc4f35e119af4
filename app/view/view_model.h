// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/panel/panel_action.h"
#include "render/panel/panel_model.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bedmix {

/// A bed that is shown.
struct ViewBed {
  std::shared_ptr<const Scene> scene;
  std::string name;         // tells it from the others
  FramePtr frame;           // null where there is none yet
  std::vector<Vec2f> path;  // of the picked particle, m
};

/// What is looked at: a run that goes on, or recorded ones. Used by one thread.
class ViewModel {
 public:
  virtual ~ViewModel() = default;

  /// Lets `seconds` of the wall clock go by and takes what is new.
  virtual void refresh(double seconds) = 0;
  /// Does what it can with it; the rest concerns the picture alone.
  virtual void act(const PanelAction& action) = 0;
  /// Everything but the picture's own.
  virtual void describe(PanelModel& panel) const = 0;
  virtual const std::vector<ViewBed>& beds() const = 0;
  /// Grows when there is something new to show.
  virtual std::uint64_t version() const = 0;
  /// What there is to say when it ends; empty for nothing.
  virtual std::string farewell() const { return {}; }
};

}  // namespace bedmix
