// SPDX-License-Identifier: MIT
#include "engine/dem/contact_list.h"

#include "engine/core/particle_list.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace bedmix {

namespace {

constexpr double skinOverDiameter = 0.4;        // measured, see assets/docs/performance.md
constexpr double innerSkinOverDiameter = 0.04;  // at least; likewise
constexpr double innerSkinOverWay = 6.0;        // likewise
constexpr double leastRemainder = 0.125;  // of the skin; with less left a new list is cheaper than measuring
constexpr std::size_t vector = 8;         // the longest vector, in doubles
constexpr std::size_t portion = 512;      // candidates looked at before room is made for more

/// Grows by a tenth and not, as resize() does by itself, to twice as much.
template <class T>
void atLeast(std::vector<T>& values, std::size_t size) {
  if (values.size() >= size) return;
  if (values.capacity() < size) values.reserve(size + size / 10);
  values.resize(size);
}

void saveHistory(StateWriter& out, const ContactSlots& slots) {
  slots.forHistory([&](const std::vector<double>& column) {
    if (!column.empty()) out.putAll(std::span(column).first(slots.count));
  });
}
bool loadHistory(StateReader& in, ContactSlots& slots) {
  bool isSound = true;
  slots.forHistory([&](std::vector<double>& column) {
    isSound = isSound && (column.empty() || in.getAll(std::span(column).first(slots.count)));
  });
  return isSound;
}

/// Blocks whose contacts are evaluated together: as large as a core's cache likes, but several strips, so
/// that few contacts cross from one to the next. The bed is `across` diameters wide.
std::size_t contactBlocks(double across, std::size_t particles) {
  const double strip = std::min(across, static_cast<double>(particles) / across);
  const double size = std::max(1024.0, 8.0 * strip);
  return std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(particles) / size));
}

/// Pairs of a block's particles, and of them and those of later blocks, that are within `reach`, m.
template <bool repeats>
void findPairs(const CellOrder& order, const Period& period, double reach, const HistoryColumns& columns,
               const std::vector<Body>& bodies, ContactBlock& block) {
  std::vector<ContactBlock::Pair>& inside = block.candidates;
  ContactSlots& crossing = block.crossing;
  std::size_t& count = block.candidateCount;
  count = 0;
  crossing.count = 0;
  const auto scan = [&](std::size_t i, Range others) {
    const Range here{others.begin, std::min(others.end, block.particles.end)};
    if (here.begin < here.end && count + here.size() > inside.size())
      atLeast(inside, inside.size() + here.size() + block.particles.size() / 8);
    for (std::size_t j = here.begin; j < here.end; ++j) {
      Vec2 apart = bodies[j].position - bodies[i].position;
      if constexpr (repeats) apart = period.nearest(apart);
      inside[count] = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
      count += static_cast<std::size_t>(dot(apart, apart) < reach * reach);
    }
    for (std::size_t j = std::max(others.begin, block.particles.end); j < others.end; ++j) {
      Vec2 apart = bodies[j].position - bodies[i].position;
      if constexpr (repeats) apart = period.nearest(apart);
      if (!(dot(apart, apart) < reach * reach)) continue;
      crossing.reserve(crossing.count + 1 + crossing.count / 2, true, columns);
      crossing.first[crossing.count] = static_cast<std::int32_t>(i);
      crossing.second[crossing.count++] = static_cast<std::int32_t>(j);
    }
  };
  if constexpr (repeats)
    order.forNeighboursAround(block.particles,
                              [&](std::size_t i, auto... ranges) { (scan(i, ranges), ...); });
  else
    order.forNeighbours(block.particles, [&](std::size_t i, Range sameStrip, Range nextStrip) {
      scan(i, sameStrip);
      scan(i, nextStrip);
    });
  crossing.reserve(crossing.count, true, columns);
  crossing.pad(static_cast<std::int32_t>(block.particles.begin));
  atLeast(block.crossingLoads, crossing.count + vector);
}

}  // namespace

HistoryColumns::HistoryColumns(const Scene& scene) : friction(scene.contacts.friction.has_value()) {
  const auto& roll = scene.contacts.rolling;
  rolling = roll && roll->model == RollingModel::elasticPlastic;
  const CohesionSettings* cohesion = scene.effects.find<CohesionSettings>();
  bridge = cohesion && cohesion->liquidBridge;
}

void ContactSlots::reserve(std::size_t slots, bool withSecond, const HistoryColumns& columns) {
  const std::size_t size = slots + vector;
  atLeast(first, size);
  if (withSecond) atLeast(second, size);
  const auto makeRoom = [&](bool isThere, std::vector<double>& column) {
    if (isThere) atLeast(column, size);
  };
  makeRoom(columns.friction, spring);
  makeRoom(columns.friction, slip);
  makeRoom(columns.rolling, rolled);
  makeRoom(columns.rolling, rollRate);
  makeRoom(columns.bridge, bridge);
}

void ContactSlots::pad(std::int32_t own) {
  std::fill_n(first.begin() + static_cast<std::ptrdiff_t>(count), vector, own);
  if (!second.empty()) std::fill_n(second.begin() + static_cast<std::ptrdiff_t>(count), vector, own);
  forHistory([&](std::vector<double>& column) {
    if (!column.empty()) std::fill_n(column.begin() + static_cast<std::ptrdiff_t>(count), vector, 0.0);
  });
}

ContactList::ContactList(const Scene& scene, const std::vector<WallSegment>& walls, std::size_t particles)
    : diameter_(particleRange(scene).largest + cohesionRange(scene)),
      wallReach_(particleRange(scene).largest / 2.0 + cohesionRange(scene)),
      skin_(skinOverDiameter * diameter_),
      period_(scene),
      columns_(scene),
      walls_(wallShapes(walls)),
      order_(diameter_ + skin_, period_.length),
      across_(scene.bed.width / scene.particles.diameter) {
  share(particles);
}

void ContactList::share(std::size_t particles) {
  ContactBlock deepest;
  for (const ContactBlock& block : blocks_)
    if (block.deepest > deepest.deepest) {
      deepest.deepest = block.deepest;
      deepest.deepestId = block.deepestId;
    }
  blocks_.resize(contactBlocks(across_, particles));
  if (deepest.deepest > 0.0) {
    blocks_[0].deepest = deepest.deepest;
    blocks_[0].deepestId = deepest.deepestId;
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].particles = blockOf(particles, blocks_.size(), b);
    for (std::size_t w = blocks_[b].walls.size(); w < walls_.size(); ++w) blocks_[b].walls.push_back({w, {}});
  }
}

void ContactList::renumber(const std::vector<std::int32_t>& places) {
  const auto renumberSlots = [&](ContactSlots& slots) {
    const bool ofPairs = !slots.second.empty();
    for (std::size_t c = 0; c < slots.count; ++c) {
      const std::int32_t first = places[slots.first[c]], second = ofPairs ? places[slots.second[c]] : 0;
      slots.first[c] = std::max(first, 0);
      if (ofPairs) slots.second[c] = std::max(second, 0);
      if (first >= 0 && second >= 0) continue;
      slots.forHistory([&](std::vector<double>& column) {
        if (!column.empty()) column[c] = 0.0;
      });
    }
  };
  for (ContactBlock& block : blocks_) {
    renumberSlots(block.near);
    renumberSlots(block.crossing);
    for (ContactBlock::AtWall& w : block.walls) renumberSlots(w.slots);
  }
}

bool ContactList::sort(const std::vector<Body>& bodies) {
  if (!order_.sort(bodies)) return false;
  if (columns_.any()) rememberContacts();
  if (built_.size() != bodies.size()) share(bodies.size());
  built_.resize(bodies.size());
  ++builds_;
  return true;
}

// By first ones in the new order: a counting sort again.
void ContactList::rememberContacts() {
  const std::vector<std::int32_t>& order = order_.order();
  placeOf_.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) placeOf_[order[k]] = static_cast<std::int32_t>(k);

  const auto forContacts = [&](auto&& visit) {
    const auto forSlots = [&](const ContactSlots& s, std::int32_t wall) {
      for (std::size_t c = 0; c < s.count; ++c) {
        bool remembers = false;
        s.forHistory(
            [&](const std::vector<double>& column) { remembers |= !column.empty() && column[c] != 0.0; });
        if (!remembers) continue;
        std::int32_t first = placeOf_[s.first[c]], second = wall;
        bool isTurned = false;
        if (wall == 0) {
          second = placeOf_[s.second[c]];
          // The spring is along t, which turns with n, and so does what it pulls at: its sign stays. How far
          // the first has rolled on the second is told from the first.
          isTurned = second < first;
          if (isTurned) std::swap(first, second);
        }
        visit(first, second, s, c, isTurned);
      }
    };
    for (const ContactBlock& block : blocks_) {
      forSlots(block.near, 0);
      forSlots(block.crossing, 0);
      for (const ContactBlock::AtWall& w : block.walls)
        forSlots(w.slots, -1 - static_cast<std::int32_t>(w.wall));
    }
  };
  rememberedStart_.assign(order.size() + 1, 0);
  forContacts([&](std::int32_t first, auto&&...) { ++rememberedStart_[first]; });
  std::int32_t end = 0;
  for (std::int32_t& s : rememberedStart_) s = end += s;
  remembered_.reserve(static_cast<std::size_t>(end), true, columns_);
  forContacts(
      [&](std::int32_t first, std::int32_t second, const ContactSlots& s, std::size_t c, bool isTurned) {
        const std::int32_t to = --rememberedStart_[first];
        remembered_.second[to] = second;
        remembered_.forHistory(
            s, [&](std::vector<double>& mine, const std::vector<double>& its) { mine[to] = its[c]; });
        if (!isTurned || !columns_.rolling) return;
        remembered_.rolled[to] = -remembered_.rolled[to];
        remembered_.rollRate[to] = -remembered_.rollRate[to];
      });
}

void ContactList::recall(ContactSlots& slots, std::int32_t wall) const {
  for (std::size_t c = 0; c < slots.count; ++c) {
    const std::int32_t first = slots.first[c], second = wall == 0 ? slots.second[c] : wall;
    std::int32_t old = rememberedStart_[first];
    while (old < rememberedStart_[first + 1] && remembered_.second[old] != second) ++old;
    const bool found = old < rememberedStart_[first + 1];
    slots.forHistory(remembered_, [&](std::vector<double>& mine, const std::vector<double>& its) {
      mine[c] = found ? its[old] : 0.0;
    });
  }
}

void ContactList::find(std::size_t b, double innerSkin, const std::vector<Body>& bodies,
                       ContactSlots& spare) {
  ContactBlock& block = blocks_[b];
  const auto find = period_.isOn() ? &findPairs<true> : &findPairs<false>;
  find(order_, period_, diameter_ + skin_, columns_, bodies, block);
  findWalls(block, bodies);
  for (std::size_t i = block.particles.begin; i < block.particles.end; ++i) built_[i] = bodies[i].position;

  block.near.count = 0;
  block.near.reserve(0, true, columns_);
  block.near.pad(static_cast<std::int32_t>(block.particles.begin));
  refresh(b, innerSkin, bodies, spare);
  if (!columns_.any()) return;
  recall(block.near, 0);
  recall(block.crossing, 0);
  for (ContactBlock::AtWall& w : block.walls) recall(w.slots, -1 - static_cast<std::int32_t>(w.wall));
}

void ContactList::findWalls(ContactBlock& block, const std::vector<Body>& bodies) {
  const double reach = wallReach_ + skin_;
  for (ContactBlock::AtWall& w : block.walls) {
    const WallShape& wall = walls_[w.wall];
    if (wall.isPlain())
      findAtWall(block, w.slots,
                 [&](std::size_t i) { return wall.distance2(bodies[i].position) < reach * reach; });
    else  // a wall that moves may come nearer by its amplitude
      findAtWall(block, w.slots,
                 [&](std::size_t i) { return wall.distance(bodies[i].position) < reach + wall.amplitude; });
  }
}

template <class IsNear>
void ContactList::findAtWall(const ContactBlock& block, ContactSlots& slots, IsNear&& isNear) const {
  slots.count = 0;
  for (std::size_t i = block.particles.begin; i < block.particles.end; ++i) {
    if (!isNear(i)) continue;
    slots.reserve(slots.count + 1 + slots.count / 2, false, columns_);
    slots.first[slots.count++] = static_cast<std::int32_t>(i);
  }
  slots.reserve(slots.count, false, columns_);
  slots.pad(static_cast<std::int32_t>(block.particles.begin));
}

void ContactList::link() {
  for (ContactBlock& block : blocks_) block.incoming.clear();
  reach_ = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ContactSlots& crossing = blocks_[b].crossing;
    for (std::size_t row = 0; row < crossing.count; ++row) {
      const std::int32_t particle = crossing.second[row];
      std::size_t to = b + 1;
      while (static_cast<std::size_t>(particle) >= blocks_[to].particles.end) ++to;
      reach_ = std::max(reach_, to - b);
      blocks_[to].incoming.push_back(
          {static_cast<std::int32_t>(b), static_cast<std::int32_t>(row), particle});
    }
  }
}

void ContactList::refresh(std::size_t b, double innerSkin, const std::vector<Body>& bodies,
                          ContactSlots& spare) {
  ContactBlock& block = blocks_[b];
  std::swap(block.near, spare);
  block.near.count = 0;
  const ContactSlots& old = spare;
  std::size_t met = 0;  // of the old ones
  for (std::size_t k = 0; k < block.candidateCount; k += portion) {
    const std::span some(block.candidates.data() + k, std::min(portion, block.candidateCount - k));
    block.near.reserve(block.near.count + some.size(), true, columns_);
    const auto chosen = period_.isOn()                        ? &ContactList::choose<Remembers::more, true>
                        : columns_.rolling || columns_.bridge ? &ContactList::choose<Remembers::more, false>
                        : columns_.friction ? &ContactList::choose<Remembers::springs, false>
                                            : &ContactList::choose<Remembers::nothing, false>;
    (this->*chosen)(some, innerSkin, bodies, old, met, block.near);
  }
  block.near.reserve(block.near.count, true, columns_);
  block.near.pad(static_cast<std::int32_t>(block.particles.begin));
  cutNear(block);
}

// A particle has had all its contacts in the block once those with it as the first are through, for they
// ascend.
void ContactList::cutNear(ContactBlock& block) {
  const ContactSlots& near = block.near;
  const std::size_t stretches = (block.particles.size() + ContactBlock::stretch - 1) / ContactBlock::stretch;
  block.nearEnd.assign(stretches, 0);
  for (std::size_t c = 0; c < near.count; ++c)
    block.nearEnd[(static_cast<std::size_t>(near.first[c]) - block.particles.begin) / ContactBlock::stretch] =
        c + 1;
  std::size_t end = 0;
  for (std::size_t& e : block.nearEnd) {
    end = std::max(end, e);
    e = std::min(near.count, (end + vector - 1) / vector * vector);
  }
}

// No branch: who is near is packed to the front, and the old ones are met in the same order.
template <ContactList::Remembers what, bool repeats>
void ContactList::choose(std::span<const ContactBlock::Pair> candidates, double innerSkin,
                         const std::vector<Body>& bodies, const ContactSlots& old, std::size_t& met,
                         ContactSlots& near) const {
  const double reach = diameter_ + innerSkin;
  constexpr double kept[] = {0.0, 1.0};
  std::size_t count = near.count;
  for (const auto& [i, j] : candidates) {
    Vec2 apart = bodies[j].position - bodies[i].position;
    if constexpr (repeats) apart = period_.nearest(apart);
    near.first[count] = i;
    near.second[count] = j;
    if constexpr (what != Remembers::nothing) {
      // Padding is a particle with itself, and no candidate.
      const bool known = ((old.first[met] ^ i) | (old.second[met] ^ j)) == 0;
      if constexpr (what == Remembers::springs) {
        near.spring[count] = kept[known] * old.spring[met];
        near.slip[count] = kept[known] * old.slip[met];
      } else {
        near.forHistory(old, [&](std::vector<double>& mine, const std::vector<double>& its) {
          mine[count] = kept[known] * its[met];
        });
      }
      met += static_cast<std::size_t>(known);
    }
    count += static_cast<std::size_t>(dot(apart, apart) < reach * reach);
  }
  near.count = count;
}

// Candidates are found again from where the particles were; which of them are near depends on when that was
// asked last, so it is told, candidate by candidate.
void ContactList::save(StateWriter& out) const {
  out.putAll(built_);
  for (const ContactBlock& block : blocks_) {
    out.put(static_cast<std::uint64_t>(block.touching));
    out.put(block.deepest);
    out.put(block.deepestId);
    std::vector<std::uint8_t> isNear(block.candidateCount);
    std::size_t met = 0;
    for (std::size_t k = 0; k < isNear.size() && met < block.near.count; ++k) {
      const auto& [first, second] = block.candidates[k];
      isNear[k] = first == block.near.first[met] && second == block.near.second[met];
      met += isNear[k];
    }
    out.putAll(isNear);
    saveHistory(out, block.near);
    saveHistory(out, block.crossing);
    for (const ContactBlock::AtWall& w : block.walls) saveHistory(out, w.slots);
  }
}

bool ContactList::load(StateReader& in, std::vector<Body>& bodies) {
  std::vector<Vec2> places(bodies.size());
  if (!in.getAll(places)) return false;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].position = places[i];
  // They stand in the order that a list of these places gives them.
  if (!sort(bodies) || !std::is_sorted(order().begin(), order().end())) return false;
  ContactSlots spare;
  for (std::size_t b = 0; b < blocks_.size(); ++b) find(b, 0.0, bodies, spare);
  link();
  for (ContactBlock& block : blocks_) {
    std::uint64_t touching = 0;
    if (!(in.get(touching) && in.get(block.deepest) && in.get(block.deepestId) && loadNear(block, in) &&
          loadHistory(in, block.near) && loadHistory(in, block.crossing)))
      return false;
    block.touching = touching;
    for (ContactBlock::AtWall& w : block.walls)
      if (!loadHistory(in, w.slots)) return false;
  }
  return true;
}

bool ContactList::loadNear(ContactBlock& block, StateReader& in) const {
  std::vector<std::uint8_t> isNear(block.candidateCount);
  if (!in.getAll(isNear)) return false;
  ContactSlots& near = block.near;
  near.reserve(isNear.size() - static_cast<std::size_t>(std::count(isNear.begin(), isNear.end(), 0)), true,
               columns_);
  near.count = 0;
  for (std::size_t k = 0; k < isNear.size(); ++k) {
    if (isNear[k] == 0) continue;
    near.first[near.count] = block.candidates[k].first;
    near.second[near.count++] = block.candidates[k].second;
  }
  near.pad(static_cast<std::int32_t>(block.particles.begin));
  cutNear(block);
  return true;
}

void ContactList::Displacements::add(double square) {
  if (square <= second) return;
  second = std::min(largest, square);
  largest = std::max(largest, square);
}

ContactList::Displacements ContactList::displacements(Range particles,
                                                      const std::vector<Body>& bodies) const {
  Displacements d;
  const bool repeats = period_.isOn();
  for (std::size_t i = particles.begin; i < particles.end; ++i) {
    Vec2 moved = bodies[i].position - built_[i];
    if (repeats) moved = period_.nearest(moved);  // they may have been moved to the other side since
    d.add(dot(moved, moved));
  }
  return d;
}

double ContactList::innerSkin(double way) const {
  return std::clamp(innerSkinOverWay * way, innerSkinOverDiameter * diameter_, skin_);
}

double ContactList::remainder(const Displacements& d) const {
  const double left = skin_ - std::sqrt(d.largest) - std::sqrt(d.second);
  return left < leastRemainder * skin_ ? -1.0 : left;
}

}  // namespace bedmix
