// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/dem/contact_history.h"
#include "engine/dem/neighbours.h"
#include "engine/dem/particles.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The linear spring and dashpot of one kind of contact, Tian et al. (2007), Eqs (5) and (7). Tangential
/// constants are unused without friction.
struct SpringDashpot {
  double reach = 0.0;                // m, distance of the centre from the other's centre or the wall at touch
  double stiffness = 0.0;            // N/m
  double damping = 0.0;              // kg/s
  double tangentialStiffness = 0.0;  // N/m
  double tangentialDamping = 0.0;    // kg/s
  double friction = 0.0;             // Coulomb's coefficient
};
SpringDashpot pairLaw(const Scene& scene);
SpringDashpot wallLaw(const Scene& scene);

/// Where forces are evaluated: one value a particle, m, m/s, rad/s (null without friction).
struct Motion {
  const double *x, *y, *vx, *vy, *spin;
};

/// The deepest contact so far.
struct OverlapRecord {
  double depth = 0.0;  // m
  std::int64_t particle = -1;
};

/// Sums over a particle's contacts.
struct ContactLoads {
  std::vector<double> fx, fy;  // N
  std::vector<double> torque;  // N m; empty without friction
  OverlapRecord deepest;       // of all evaluations
};

/// Some contacts side by side, so that the law is one plain loop over arrays. Vectors point from the particle
/// to the other particle or the wall.
struct ContactBatch {
  static constexpr std::size_t capacity = 128;
  alignas(64) double dx[capacity], dy[capacity];    // m
  alignas(64) double dvx[capacity], dvy[capacity];  // m/s, of the other relative to the particle
  alignas(64) double rolling[capacity];             // m/s, slip due to spin
  alignas(64) double spring[capacity], slip[capacity];
  alignas(64) double fx[capacity], fy[capacity];  // N, on the particle
  alignas(64) double tangential[capacity];        // N, along t
};

/// Evaluates all contact forces of a bed. `friction` is chosen when the solver is built: without it there is
/// no tangential force, no torque and no history but the list of those that touch.
template <bool friction>
class ContactForces {
 public:
  explicit ContactForces(const Scene& scene);

  /// Fills `loads` with forces and torques at `at` and `to`, which must be clear, with the contacts' new
  /// history. A spring grows by halfStep (s) times its old and its new slip; at Coulomb's limit it is set so
  /// that spring and dashpot together give just that. Forces on a particle are added in this order: from
  /// particles with smaller ids, ascending, from those with larger, ascending, from walls.
  void evaluate(const Motion& at, const NeighbourList& list, const ContactHistory& from, double halfStep,
                ContactHistory& to, ContactLoads& loads);

 private:
  void findTouchingPairs(const Motion& at, const NeighbourList& list, ContactHistory& to) const;
  void addPairs(const Motion& at, const NeighbourList& list, const ContactHistory& from, double halfStep,
                ContactHistory& to, ContactLoads& loads);
  void addWalls(const Motion& at, const NeighbourList& list, const ContactHistory& from, double halfStep,
                ContactHistory& to, ContactLoads& loads);
  void applyLaw(const SpringDashpot& law, double halfStep, std::size_t count);

  SpringDashpot pair_, wall_;
  double radius_;
  ContactBatch batch_;
};

}  // namespace bedmix
