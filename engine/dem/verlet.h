// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/contact_forces.h"
#include "engine/dem/integrator.h"
#include "engine/dem/motion_kernel.h"

#include <vector>

namespace bedmix {

/// Second order. The dashpots see the velocity predicted to the end of the step, v + a dt, the tangential
/// springs grow by the trapezoidal rule. A step is two walks over the blocks, motion and contacts, after each
/// of which all members meet.
class VelocityVerlet {
 public:
  VelocityVerlet(const Scene& scene, const BedState& bed);

  void begin(BedState& bed);
  StepOutcome advance(BedState& bed, std::int64_t steps, double maxOverlap);

 private:
  /// What a member keeps for itself; budgets and outcomes are the same for all.
  struct Member {
    int index;
    Range blocks;
    SkinBudget budget;
    LapTimer timer;
    DemSeconds seconds;
    StepOutcome outcome;
  };
  Member start(const BedState& bed, int index) const;
  void walk(BedState& bed, Member& m, std::int64_t steps, double maxOverlap);
  void move(BedState& bed, Member& m, double (MotionKernel::*how)(Range) const, bool withIncoming);
  bool keepLists(BedState& bed, Member& m);
  bool rebuild(BedState& bed, Member& m);
  void evaluate(BedState& bed, const Member& m, const ContactForces& contacts);
  MotionKernel motion(BedState& bed) const;

  ContactForces atStart_, contacts_;
  std::vector<ContactSlots> spare_;                        // of each member
  std::vector<double> fastest2_;                           // of each block, (m/s)2
  std::vector<ContactList::Displacements> displacements_;  // likewise
  bool sorted_ = true;
};

}  // namespace bedmix
