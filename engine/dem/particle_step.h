// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/dem/contact_error.h"
#include "engine/dem/particle_solver.h"

#include <cstdint>
#include <optional>

namespace bedmix {

/// Chooses the particles' steps where a scene leaves them to it (time.step = "auto"): the longest at which
/// every contact that is there, or that may begin before the next choice, parts with a speed that errs by
/// time.error sqrt(g d) at most; without gravity by time.error times the hardest impact of that time. Never
/// longer than the fastest particle takes for a tenth of its diameter, nor than lets a packed bed rest.
///
/// The bound holds for contacts during which the step stays what it is, as it does through the hardest: it
/// grows only once no impact has asked for it for a time T. Milder ones that are under way when a harder one
/// shortens it, by a factor r, miss up to (w dt)2/16 (1 - r2) of their speed. Chosen from the bed alone: two
/// of one past stay the same to the bit.
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
  Outcome advance(double span, ParticleSolver& solver);

  void save(StateWriter& out) const;
  /// False where `in` is not what save() wrote.
  [[nodiscard]] bool load(StateReader& in);

 private:
  void follow(double needed, double since);
  double longest(double span, ParticleSolver& solver) const;

  ContactError error_;
  double allowed_;  // m/s; without gravity of the closing speed
  bool hasGravity_;
  double limit_, shortest_;  // s
  double nearest_, hold_;    // s, that impacts are foreseen at least and at most
  double way_;               // m
  double step_;              // s
  double calm_ = 0.0;        // s, for which longer ones would have done
};

}  // namespace bedmix
