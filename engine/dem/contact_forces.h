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
  /// Springs grow by halfStep (s) times their old and their new slip.
  ContactForces(const Scene& scene, double halfStep);

  /// Adds the contacts of a block to its particles' loads, and keeps what goes to later blocks in it. Sums
  /// run over pairs as they ascend, then over those that cross, then over walls; addIncoming() comes last.
  /// history(slots, k) gives the history of the k-th array of contacts.
  template <class History>
  void evaluate(BedState& bed, std::size_t b, const Motion& at, History&& history) const {
    ContactBlock& block = bed.contacts.block(b);
    block.touching = 0;
    std::size_t k = 0;
    addNear(bed, block, at, history(block.near, k++));
    addCrossing(bed, block, at, history(block.crossing, k++));
    for (ContactBlock::AtWall& w : block.walls) addWall(bed, block, w, at, history(w.slots, k++));
  }

  /// Adds what contacts of earlier blocks do to this one's particles.
  static void addIncoming(BedState& bed, std::size_t block);

 private:
  void addNear(BedState& bed, ContactBlock& block, const Motion& at, const Tangential& t) const;
  void addCrossing(BedState& bed, ContactBlock& block, const Motion& at, const Tangential& t) const;
  void addWall(BedState& bed, ContactBlock& block, const ContactBlock::AtWall& w, const Motion& at,
               const Tangential& t) const;

  ContactKernel pair_, wall_;
};

}  // namespace bedmix
