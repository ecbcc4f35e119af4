// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The ids of particles, ascending. In this order stand the rows of frames and whatever is kept one by one
/// beside the particles.
class Roster {
 public:
  explicit Roster(std::vector<std::int32_t> unsorted = {});

  const std::vector<std::int32_t>& ids() const { return ids_; }
  /// Whether they count up from 0, as where nobody has come or gone.
  bool isDense() const { return isDense_; }
  /// Of one that is there.
  std::size_t rowOf(std::int32_t id) const { return isDense_ ? static_cast<std::size_t>(id) : find(id); }

 private:
  std::size_t find(std::int32_t id) const;

  std::vector<std::int32_t> ids_;
  bool isDense_ = true;  // they count up from 0
};

/// Particles that come and go between two steps.
struct PopulationChange {
  struct Newcomer {
    std::int32_t id;          // more than any was before
    double radius, mass;      // m, kg
    std::uint8_t kind;        // number of particleKinds()
    std::size_t stream;       // of the feed, by which it comes
    Vec2 position, velocity;  // m, m/s; without spin
  };
  std::vector<std::size_t> gone;  // rows, ascending
  std::vector<Newcomer> come;

  bool empty() const { return gone.empty() && come.empty(); }
  /// Does the same to values one a row; `valueOf` makes those of the newcomers.
  template <class T, class Make>
  void apply(std::vector<T>& rows, const Make& valueOf) const {
    std::size_t kept = 0;
    for (std::size_t row = 0, next = 0; row < rows.size(); ++row) {
      if (next < gone.size() && gone[next] == row)
        ++next;
      else
        rows[kept++] = rows[row];
    }
    rows.resize(kept);
    for (const Newcomer& newcomer : come) rows.push_back(valueOf(newcomer));
  }
};

/// Moves values to their new places, which ascend; those whose place is negative are dropped.
template <class T>
void keepPlaces(std::vector<T>& values, const std::vector<std::int32_t>& places) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (places[i] < 0) continue;
    values[static_cast<std::size_t>(places[i])] = values[i];
    ++kept;
  }
  values.resize(kept);
}

}  // namespace bedmix
