// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/bed_state.h"
#include "engine/dem/contacts.h"

#include <array>
#include <cstddef>
#include <vector>

// Each integrator has begin(), called once before the first step, of a finite bed, and step(). Positions,
// velocities and history belong to the same instant after either. step() returns false where a neighbour list
// would have to be built of particles that are no longer at finite places; otherwise its caller looks for
// that.

namespace bedmix {

/// Second order. The dashpots see the velocity predicted to the end of the step, v + a dt, the tangential
/// springs grow by the trapezoidal rule.
template <bool friction>
class VelocityVerlet {
 public:
  VelocityVerlet(const Scene& scene, std::size_t particles);

  void begin(BedState& bed);
  bool step(BedState& bed);

 private:
  double drift(BedState& bed);
  void evaluate(BedState& bed, double halfStep);
  void kick(BedState& bed);
  bool rebuild(BedState& bed);

  ContactForces<friction> contacts_;
  ContactHistory next_;
  std::vector<double> vx_, vy_, spin_;  // predicted to the end of the step
};

/// Fourth order where the forces are smooth, which they are not where contacts begin, end or start to slide.
/// Tangential springs are part of the state; the neighbour list is fixed within a step.
template <bool friction>
class RungeKutta4 {
 public:
  RungeKutta4(const Scene& scene, std::size_t particles);

  void begin(BedState& bed);
  bool step(BedState& bed);

 private:
  /// One value a particle of everything that moves, or of its rate of change.
  struct Values {
    std::vector<double> x, y, vx, vy, spin;
  };
  /// Tries a step; false, and nothing changed, where the neighbour list does not reach as far.
  bool attempt(BedState& bed, bool force);
  void addRate(const BedState& bed, double weight);
  double moveFromStart(const BedState& bed, double duration);
  void growSprings(const ContactHistory& before, double duration);
  double finish(BedState& bed);
  bool rebuild(BedState& bed);

  ContactForces<friction> contacts_;
  std::array<ContactHistory, 4> stages_;
  ContactHistory trial_;
  Values at_, sum_;
};

}  // namespace bedmix
