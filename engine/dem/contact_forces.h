// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/bed_state.h"
#include "engine/dem/contact_kernel.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bedmix {

/// The history of contacts where they stand: Verlet's is read and written in place.
inline Tangential inPlace(ContactSlots& slots) {
  const auto orNull = [](std::vector<double>& values) { return values.empty() ? nullptr : values.data(); };
  double *const spring = orNull(slots.spring), *const slip = orNull(slots.slip);
  return {spring, slip, spring, slip, orNull(slots.rolled), orNull(slots.rollRate), orNull(slots.bridge)};
}

/// Where a bed's contacts are evaluated; walls are where they are at the time, s.
inline Motion motionOf(const BedState& bed, double time) {
  const auto orNull = [](const auto& values) { return values.empty() ? nullptr : values.data(); };
  const Particles& p = bed.particles;
  return {bed.bodies.data(), orNull(bed.spinAhead), orNull(p.radii), orNull(p.masses), orNull(p.kinds), time};
}

/// Evaluates the contacts of a bed, block by block.
class ContactForces {
 public:
  /// Springs do not grow before setStep().
  explicit ContactForces(const Scene& scene);
  ContactForces(const ContactForces&) = delete;  // kernels point to the effects
  ContactForces& operator=(const ContactForces&) = delete;
  /// Springs grow by half of this (s) times their old and their new slip.
  void setStep(double seconds) { pair_.halfStep = wall_.halfStep = 0.5 * seconds; }

  /// Adds the contacts of a block to its particles' loads, and keeps what goes to later blocks in it: those
  /// that cross into later ones, then those at walls, then pairs within it as they ascend. history(slots, k)
  /// gives the history of the k-th array of contacts.
  template <class History>
  void evaluate(BedState& bed, std::size_t b, const Motion& at, History&& history) const {
    ContactBlock& block = bed.contacts.block(b);
    std::size_t k = 0;
    addCrossing(bed, b, at, history(block.crossing, k++));
    for (ContactBlock::AtWall& w : block.walls) addWall(bed, block, w, at, history(w.slots, k++));
    addNear(bed, b, at, {0, block.near.count}, history(block.near, k++));
  }

  /// The same one after the other; crossing ones, which come first, may be added long before the rest.
  void addCrossing(BedState& bed, std::size_t block, const Motion& at, const Tangential& t) const;
  void addWalls(BedState& bed, std::size_t block, const Motion& at) const;
  void addNear(BedState& bed, std::size_t block, const Motion& at, Range slots, const Tangential& t) const;

  /// Adds what contacts of earlier blocks do to this one's particles.
  static void addIncoming(BedState& bed, std::size_t block);

 private:
  void addWall(BedState& bed, ContactBlock& block, const ContactBlock::AtWall& w, const Motion& at,
               const Tangential& t) const;
  void addWall(BedState& bed, ContactBlock& block, const ContactSlots& slots, const WallShape& wall,
               const Motion& at, const Tangential& t) const;

  std::optional<ContactEffects> effects_;  // none where the kernels' are
  ContactKernel pair_, wall_;
};

}  // namespace bedmix
