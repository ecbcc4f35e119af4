// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/dem/contact_error.h"
#include "engine/dem/particle_solver.h"

namespace bedmix {

/// Chooses the particles' steps where a scene leaves them to it (time.step = "auto"): the longest at which
/// every contact that is there, or that may begin before the next choice, parts with a speed that errs by
/// time.error sqrt(g d) at most; without gravity by time.error times its closing speed. Never longer than
/// T/14, nor than the fastest particle takes for a tenth of its diameter. Chosen from the state of the bed
/// alone, so two of one state are the same to the bit.
class ParticleStep {
 public:
  explicit ParticleStep(const Scene& scene);

  /// Sets the solver's step for the coming `span`, s; returns how many make it.
  std::int64_t divide(double span, ParticleSolver& solver) const;

 private:
  ContactError error_;
  double allowed_ = 0.0;  // m/s; of the closing speed without gravity
  bool relative_ = false;
  double shortest_, furthest_;  // s, m
};

}  // namespace bedmix
