// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/contact_forces.h"
#include "engine/dem/integrator.h"
#include "engine/dem/motion_kernel.h"

#include <vector>

namespace bedmix {

/// Velocity Verlet, whose dashpots see the velocity predicted to the end of the step, v + a dt, with the
/// force of the instant or, of second order also where contacts begin and end, of the step around it; and
/// symplectic Euler, of first order. Tangential springs grow by the trapezoidal rule. The end of a step and
/// the beginning of the next are one pass over memory.
class Verlet {
 public:
  Verlet(const Scene& scene, const BedState& bed);

  void begin(BedState& bed);
  void goOn(BedState&) {}  // keeps nothing from step to step
  void relist(BedState& bed);
  StepOutcome advance(BedState& bed, std::int64_t steps, double maxOverlap);

 private:
  /// What a member keeps for itself; budgets and outcomes are the same for all.
  struct Member {
    int index;
    Range blocks;
    SkinBudget budget;
    StepOutcome outcome = {};
    // Wall seconds of the first member, which stand for all; `sampled` where this step is looked at closely.
    double neighbours = 0.0, others = 0.0;
    bool sampled = false;
    LapTimer timer = {}, closer = {};

    void lap(double& stage) {
      if (index == 0) timer.lap(stage);
    }
    /// Adds to a share, or to none.
    void sample(double* share) {
      double skipped = 0.0;
      if (sampled) closer.lap(share ? *share : skipped);
    }
  };
  void resize(const BedState& bed);
  Member start(const BedState& bed, int index) const;
  void walk(BedState& bed, Member& m, std::int64_t steps, double maxOverlap);
  bool keepLists(BedState& bed, Member& m);
  bool rebuild(BedState& bed, Member& m, double way);
  double finish(BedState& bed, std::size_t b, Member& m, const MotionKernel& kernel, bool last);
  MotionKernel motion(BedState& bed) const;

  ContactForces contacts_;
  bool halves_;        // velocities go half a step at a time, see MotionKernel
  double reachAhead_;  // of what the fastest goes in a step: gap of those that may push each other
  std::vector<ContactSlots> spare_;  // of each member
  // Of each block; written after the members' second meeting in a step, read after the first.
  std::vector<double> fastest2_;  // (m/s)2
  std::vector<double> deepest_;   // overlap, m
  std::vector<ContactList::Displacements> displacements_;
  bool sorted_ = true;
  std::int64_t stepsBefore_ = 0;                   // of earlier calls
  double contactShare_ = 0.0, motionShare_ = 0.0;  // s, of the sampled steps
};

}  // namespace bedmix
