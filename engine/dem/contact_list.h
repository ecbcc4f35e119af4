// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/blocks.h"
#include "engine/core/period.h"
#include "engine/core/state_bytes.h"
#include "engine/core/vec2.h"
#include "engine/dem/cell_order.h"
#include "engine/dem/rows.h"
#include "engine/dem/wall_shape.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bedmix {

/// What contacts remember from step to step.
struct HistoryColumns {
  bool friction = false, rolling = false, bridge = false;

  explicit HistoryColumns(const Scene& scene);
  bool any() const { return friction || rolling || bridge; }
};

/// Pairs of particles, or particles at one wall, that may touch, side by side, with the history of those that
/// do: contacts keep it where they stand. Padded to whole vectors.
struct ContactSlots {
  std::vector<std::int32_t> first, second;  // places in memory, first < second; at a wall first alone
  std::vector<double> spring, slip;         // m and m/s, 0 for who does not touch; empty without friction
  std::vector<double> rolled, rollRate;     // rad and rad/s, likewise; empty without a rolling spring
  std::vector<double> bridge;               // 1 where a liquid bridge is; empty without
  std::size_t count = 0;

  /// Calls visit(column) for what they remember, whether it is there or empty.
  template <class Visit>
  void forHistory(Visit&& visit) {
    for (std::vector<double>* column : {&spring, &slip, &rolled, &rollRate, &bridge}) visit(*column);
  }
  template <class Visit>
  void forHistory(Visit&& visit) const {
    for (const std::vector<double>* column : {&spring, &slip, &rolled, &rollRate, &bridge}) visit(*column);
  }
  /// Calls visit(mine, others) for each column that is there.
  template <class Visit>
  void forHistory(const ContactSlots& other, Visit&& visit) {
    const auto pair = [&](std::vector<double>& mine, const std::vector<double>& others) {
      if (!mine.empty()) visit(mine, others);
    };
    pair(spring, other.spring);
    pair(slip, other.slip);
    pair(rolled, other.rolled);
    pair(rollRate, other.rollRate);
    pair(bridge, other.bridge);
  }

  /// Room for as many, whole vectors.
  void reserve(std::size_t slots, bool withSecond, const HistoryColumns& columns);
  /// Fills the last vector up with `own`, any particle of the block.
  void pad(std::int32_t own);
};

/// Contacts of one block of particles, so that whoever works on a block writes to nobody else's.
struct ContactBlock {
  struct Pair {
    std::int32_t first, second;
  };
  /// A row of a crossing contact, and the particle here that gets it.
  struct Incoming {
    std::int32_t block, row, particle;
  };
  struct AtWall {
    std::size_t wall = 0;
    ContactSlots slots;
  };

  /// Particles that are moved together once their contacts are through, while they are in the innermost
  /// cache.
  static constexpr std::size_t stretch = 128;

  Range particles;
  std::vector<Pair> candidates;  // within the skin, both in the block; the first `candidateCount` are valid
  std::size_t candidateCount = 0;
  ContactSlots near;                 // those of them within the inner skin
  std::vector<std::size_t> nearEnd;  // of each stretch of particles: where their contacts are through
  ContactSlots crossing;             // within the skin, the second in a later block
  std::vector<Load> crossingLoads;   // on the second ones
  std::vector<Incoming> incoming;    // what this block gets from earlier ones, in their order
  std::vector<AtWall> walls;

  std::size_t touching = 0;  // at the last evaluation
  double deepest = 0.0;      // overlap so far, m
  std::int64_t deepestId = -1;
};

/// What the skins have left, m.
struct SkinBudget {
  double outer = 0.0, inner = 0.0;
  void spend(double distance) {
    outer -= 2.0 * distance;
    inner -= 2.0 * distance;
  }
};

/// Verlet's list, twice: candidates closer than a diameter plus a skin, and of these again and again the few
/// closer than a diameter plus a much smaller inner skin, which are all that a step looks at. Either holds
/// while the two largest displacements since it was made add up to less than its skin; 2 v_max dt is their
/// bound after Tian et al. (2007), Eq. (11). Pairs ascend in memory, and sums over them with them.
class ContactList {
 public:
  ContactList(const Scene& scene, const std::vector<WallSegment>& walls, std::size_t particles);

  std::size_t blocks() const { return blocks_.size(); }
  ContactBlock& block(std::size_t b) { return blocks_[b]; }
  const ContactBlock& block(std::size_t b) const { return blocks_[b]; }
  const std::vector<WallShape>& walls() const { return walls_; }
  /// By which particles that are not moved to the other side before the list is made anew are neighbours.
  const Period& period() const { return period_; }
  std::int64_t builds() const { return builds_; }
  /// How many blocks further contacts reach at most.
  std::size_t reach() const { return reach_; }

  /// A new list is made in three steps, each once all members have done the last one: sort() by one of them,
  /// who then moves the particles to their new order() unless it is false, not all being at finite places;
  /// find() for each block, which picks the near ones too; and link() by one.
  bool sort(const std::vector<Body>& bodies);
  const std::vector<std::int32_t>& order() const { return order_.order(); }
  void find(std::size_t block, double innerSkin, const std::vector<Body>& bodies, ContactSlots& spare);
  void link();
  /// Picks those within the inner skin (m) anew. `spare` lends its memory; one a member.
  void refresh(std::size_t block, double innerSkin, const std::vector<Body>& bodies, ContactSlots& spare);

  /// The inner skin to choose where the fastest goes `way` (m) in a step.
  double innerSkin(double way) const;
  SkinBudget fullBudget(double way) const { return {skin_, innerSkin(way)}; }
  /// Squares of the two largest displacements in a block since the list was made.
  struct Displacements {
    double largest = 0.0, second = 0.0;
    void add(double square);
  };
  Displacements displacements(Range particles, const std::vector<Body>& bodies) const;
  /// What is left of the skin after that; negative where it is too little to go on with.
  double remainder(const Displacements& d) const;

  /// Before a new list of other particles, whose number may change that of the blocks: those there are go to
  /// `places`, which ascend, or away where that is negative.
  void renumber(const std::vector<std::int32_t>& places);

  void save(StateWriter& out) const;
  /// Into a list that has not been made yet, of particles in the order they had in the saved one. Leaves
  /// `bodies` where they were when that was made. False where `in` is not what save() wrote of them.
  [[nodiscard]] bool load(StateReader& in, std::vector<Body>& bodies);

 private:
  void share(std::size_t particles);
  void rememberContacts();
  void findWalls(ContactBlock& block, const std::vector<Body>& bodies);
  template <class IsNear>
  void findAtWall(const ContactBlock& block, ContactSlots& slots, IsNear&& isNear) const;
  static void cutNear(ContactBlock& block);
  void recall(ContactSlots& slots, std::int32_t wall) const;
  bool loadNear(ContactBlock& block, StateReader& in) const;
  enum class Remembers { nothing, springs, more };
  template <Remembers what, bool repeats>
  void choose(std::span<const ContactBlock::Pair> candidates, double innerSkin,
              const std::vector<Body>& bodies, const ContactSlots& old, std::size_t& met,
              ContactSlots& near) const;

  double diameter_, wallReach_, skin_;  // m, within which bodies may act on each other; beyond it
  Period period_;
  HistoryColumns columns_;
  std::int64_t builds_ = 0;
  std::size_t reach_ = 0;
  std::vector<WallShape> walls_;
  CellOrder order_;
  double across_;  // width of the bed, in diameters
  std::vector<ContactBlock> blocks_;
  std::vector<Vec2> built_;  // where the particles were when the list was made
  ContactSlots remembered_;  // by their first in the new order; second is -1 - wall at a wall
  std::vector<std::int32_t> rememberedStart_;  // of each first, and one past the last
  std::vector<std::int32_t> placeOf_;          // in the new order, by the old one
};

}  // namespace bedmix
