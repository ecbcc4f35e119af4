// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/dem/contact_error.h"
#include "engine/dem/particle_solver.h"

#include <cstdint>
#include <optional>

namespace bedmix {

/// Chooses the particles' steps where a scene leaves them to it (time.step = "auto"): the longest at which
/// every contact that is there, or that may begin before the next choice, parts with a speed that errs by
/// time.error sqrt(g d) at most; without gravity by time.error times the hardest impact of that time. Never
/// longer than the fastest particle takes for a tenth of its diameter, nor than lets a packed bed rest.
/// Chosen from the state of the bed alone, anew before that has changed much: two beds of one state stay the
/// same to the bit.
class ParticleStep {
 public:
  explicit ParticleStep(const Scene& scene);

  struct Outcome {
    std::int64_t steps = 0;  // taken
    double seconds = 0.0;    // that they make
    std::optional<DemTrouble> trouble;
  };
  /// The longest that it chooses, s: T/25, above which a packed bed with friction hums at up to a tenth of
  /// sqrt(g d), or T/14 where time.error is as much; but no longer than dashpots of particles with six
  /// neighbours let each other rest, 0.8 m/(6 eta). Measured.
  static double limit(const Scene& scene);

  /// Advances the bed by `span`, s, in steps that end with it.
  Outcome advance(double span, ParticleSolver& solver) const;

 private:
  double longest(double span, ParticleSolver& solver) const;

  ContactError error_;
  double allowed_;  // m/s; without gravity of the closing speed
  bool hasGravity_;
  double limit_, shortest_;    // s
  double nearest_, farthest_;  // s, that impacts are foreseen
  double way_;                 // m
};

}  // namespace bedmix
