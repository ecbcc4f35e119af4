// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/bed_state.h"
#include "engine/dem/contact_kernel.h"

#include <cstddef>

namespace bedmix {

/// The history of contacts where they stand: Verlet's is read and written in place.
inline Tangential inPlace(ContactSlots& slots) {
  if (slots.spring.empty()) return {};
  return {slots.spring.data(), slots.slip.data(), slots.spring.data(), slots.slip.data()};
}

/// Evaluates the contacts of a bed, block by block.
class ContactForces {
 public:
  /// Springs do not grow before setStep().
  explicit ContactForces(const Scene& scene);
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

  ContactKernel pair_, wall_;
};

}  // namespace bedmix
