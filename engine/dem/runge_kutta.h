// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/contact_forces.h"
#include "engine/dem/integrator.h"

#include <array>
#include <vector>

namespace bedmix {

/// Fourth order where the forces are smooth, which they are not where contacts begin, end or start to slide.
/// Tangential springs are part of the state; the contact lists are fixed within a step. One thread.
class RungeKutta4 {
 public:
  RungeKutta4(const Scene& scene, const BedState& bed);

  void begin(BedState& bed);
  void goOn(BedState& bed) { fitHistory(bed); }
  void relist(BedState& bed);
  StepOutcome advance(BedState& bed, std::int64_t steps, double maxOverlap);

 private:
  /// One rate of change a particle of everything that moves.
  struct Rates {
    std::vector<Vec2> position, velocity;
    std::vector<double> spin;
  };
  /// Of one array of contacts.
  struct History {
    std::vector<double> start;                // springs as the first stage leaves them
    std::vector<double> trial;                // springs a stage begins with
    std::vector<double> left;                 // and leaves
    std::array<std::vector<double>, 4> slip;  // of the stages
  };
  /// Tries a step; false, and nothing changed, where the lists do not reach as far.
  bool attempt(BedState& bed, bool force);
  void evaluate(BedState& bed, std::size_t stage);
  Vec2 acceleration(const BedState& bed, const double* masses, std::size_t i) const;
  void addRate(const BedState& bed, double weight);
  double moveFromStart(BedState& bed, double duration);
  void growSprings(std::size_t stage, double duration);
  double finish(BedState& bed);
  bool renewLists(BedState& bed);
  bool rebuild(BedState& bed);
  void makeLists(BedState& bed);
  void fitHistory(BedState& bed);

  ContactForces contacts_;
  Rates sum_;                     // over the stages
  std::vector<History> history_;  // of each array of contacts, block by block
  ContactSlots spare_;
};

}  // namespace bedmix
