// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/design.h"
#include "app/accuracy/lazy_map.h"
#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "engine/dem/particles.h"

#include <string>

namespace bedmix {

/// What settings are run from: the same for all that settle alike. Made when first asked for, and kept; from
/// any thread.
class StartStates {
 public:
  explicit StartStates(const Scene& scene) : scene_(scene) {}

  /// The bed as the run of a seed begins: with the scene's own step (for another stiffness, a step as fine),
  /// whatever that of the setting.
  const Result<Particles>& settled(const Setting& setting, int seedOffset);
  /// The bed in motion: positions, velocities and spins of the scene itself after developedAfter().
  const Result<Particles>& developed(int seedOffset);
  double developedAfter() const;  // s

 private:
  Scene scene_;
  LazyMap<std::pair<double, int>, Result<Particles>> settled_;
  LazyMap<int, Result<Particles>> developed_;
};

/// Goes on from a frame; float precision, springs begin anew.
Particles particlesOf(const Scene& scene, const Frame& frame);

}  // namespace bedmix
