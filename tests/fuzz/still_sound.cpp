// SPDX-License-Identifier: MIT
#include "tests/fuzz/still_sound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace bedmix::fuzz {

void require(bool holds, const char* what) {
  if (holds) return;
  fmt::print(stderr, "broken: {}\n", what);
  std::abort();
}

void requireFinite(const Frame& frame) {
  const auto number = [](float v) { return std::isfinite(v); };
  const auto vector = [](Vec2f v) { return std::isfinite(v.x) && std::isfinite(v.y); };
  require(std::isfinite(frame.time), "time is finite");
  require(std::ranges::all_of(frame.position, vector), "positions are finite");
  require(std::ranges::all_of(frame.velocity, vector), "velocities are finite");
  require(std::ranges::all_of(frame.angularVelocity, number), "spins are finite");
  require(std::ranges::all_of(frame.temperature, number), "temperatures are finite");
  require(std::ranges::all_of(frame.gas.temperature, number), "gas temperatures are finite");
  require(std::ranges::all_of(frame.gas.voidage, number), "voidages are finite");
  require(std::ranges::all_of(frame.gas.pressure, number), "pressures are finite");
  require(std::ranges::all_of(frame.gas.velocity, vector), "gas velocities are finite");
}

void requireSoundSteps(Simulation& simulation) {
  if (const auto trouble = simulation.advance(100))
    require(!trouble->empty(), "an end has a reason");
  else
    requireFinite(*simulation.frame());
}

}  // namespace bedmix::fuzz
