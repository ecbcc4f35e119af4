// SPDX-License-Identifier: MIT
#pragma once

#include "replay/analysis/analysis.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <limits>
#include <string_view>
#include <vector>

// Frames whose analysis is known, and what was made of them.

namespace bedmix::test {

/// A frame with particles 0, 1, ... there, at rest.
inline Frame frameOf(double time, const std::vector<Vec2>& places) {
  Frame frame;
  frame.time = time;
  for (Vec2 place : places) {
    frame.id.push_back(static_cast<std::int32_t>(frame.id.size()));
    frame.position.push_back(toFloat(place));
    frame.velocity.push_back({});
    frame.species.push_back(0);
  }
  return frame;
}

/// Without the particles whose id is a multiple of `n`.
inline Frame without(const Frame& frame, int n) {
  Frame rest;
  rest.time = frame.time;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame.id[i] % n == 0) continue;
    rest.id.push_back(frame.id[i]);
    rest.position.push_back(frame.position[i]);
    rest.velocity.push_back(frame.velocity[i]);
    rest.species.push_back(frame.species[i]);
  }
  return rest;
}

/// Places `spacing` apart that fill a bed, half of that from its walls.
inline std::vector<Vec2> lattice(double width, double height, double spacing) {
  std::vector<Vec2> places;
  for (double y = spacing / 2; y < height; y += spacing)
    for (double x = spacing / 2; x < width; x += spacing) places.push_back({x, y});
  return places;
}

/// The value found under that name; NaN where it is not defined, and the test fails where nothing has the
/// name.
inline double found(const Analysis& analysis, std::string_view name) {
  for (const FoundNumber& f : analysis.findings())
    if (f.name == name) return f.value.value_or(std::numeric_limits<double>::quiet_NaN());
  ADD_FAILURE() << "nothing is called " << name;
  return 0.0;
}

inline Table tableOf(const Analysis& analysis, std::string_view name) {
  for (NamedTable& t : analysis.tables())
    if (t.name == name) return std::move(t.table);
  ADD_FAILURE() << "no table is called " << name;
  return {};
}

inline double at(const Table& table, std::string_view column, std::size_t row) {
  const Table::Column* values = table.find(column);
  if (!values || row >= values->size()) {
    ADD_FAILURE() << "no row " << row << " of " << column;
    return 0.0;
  }
  return (*values)[row].value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace bedmix::test
