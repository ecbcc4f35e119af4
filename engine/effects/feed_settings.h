// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// Particles that come in on a level line, one by one, at random places of it.
struct FeedStream {
  std::string species = {};                // name of a kind; the first where absent
  double rate = 0.0;                       // 1/s
  double from = 0.0;                       // m, of the line
  double to = 0.0;                         // m
  double y = 0.0;                          // m
  double vx = 0.0;                         // m/s, with which they come in
  double vy = 0.0;                         // m/s, upward
  std::optional<double> temperature = {};  // K, with heat
};

/// Particles with their centre in this box are taken out.
struct FeedOutlet {
  double from = 0.0;    // m
  double to = 0.0;      // m
  double bottom = 0.0;  // m
  double top = 0.0;     // m
};

/// Continuous operation; see FeedStage.
struct FeedSettings {
  static constexpr Key table{"feed", "", {}, "switches on particles that come in and go out while it runs"};

  std::int64_t most = 0;  // particles at a time
  std::vector<FeedStream> streams;
  std::vector<FeedOutlet> outlets;
};

template <class V>
void describe(FeedStream& s, V& visit) {
  visit(Key{"species", "", {}, "name of the kind that comes in; the first where absent"}, s.species);
  visit(Key{"rate", "1/s", positive, "particles that come in, on average", true}, s.rate);
  visit(Key{"from", "m", notNegative, "left end of the line they come in on", true}, s.from);
  visit(Key{"to", "m", notNegative, "right end of it", true}, s.to);
  visit(Key{"y", "m", notNegative, "height of it", true}, s.y);
  visit(Key{"vx", "m/s", {}, "their velocity to the right"}, s.vx);
  visit(Key{"vy", "m/s", {}, "their velocity upward"}, s.vy);
  visit(Key{"temperature", "K", {0.0, 5000.0}, "their temperature; heat.temperature where absent"},
        s.temperature);
}
template <class V>
void describe(FeedOutlet& s, V& visit) {
  visit(Key{"from", "m", notNegative, "left side of the box", true}, s.from);
  visit(Key{"to", "m", notNegative, "right side", true}, s.to);
  visit(Key{"bottom", "m", notNegative, "lower side", true}, s.bottom);
  visit(Key{"top", "m", notNegative, "upper side", true}, s.top);
}
template <class V>
void describe(FeedSettings& s, V& visit) {
  visit(Key{"most", "", {1.0, 1e8}, "particles there may be at a time; who would come beyond waits", true},
        s.most);
  visit(Key{"streams", "", {}, "where particles come in"}, s.streams);
  visit(Key{"outlets", "", {}, "boxes that take out who comes into them"}, s.outlets);
}

std::vector<Contradiction> contradictions(const Scene& scene, const FeedSettings& feed);

/// What comes in by all streams, 1/s; 0 without feed.
double feedRate(const Scene& scene);

}  // namespace bedmix
