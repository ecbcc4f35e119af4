// SPDX-License-Identifier: MIT
#include "replay/foreign/lammps_columns.h"

#include "replay/foreign/word_reader.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

LammpsColumns::LammpsColumns(std::string_view names, const SourceLocation& at) {
  for (WordReader words(names, at); words.findInLine();) names_.push_back(words.word());
  places_.resize(names_.size(), unused);

  struct Form {
    const char *x, *y, *z;
    bool isScaled;
  };
  constexpr Form forms[] = {{"x", "y", "z", false},
                            {"xu", "yu", "zu", false},
                            {"xs", "ys", "zs", true},
                            {"xsu", "ysu", "zsu", true}};
  const auto form = std::find_if(std::begin(forms), std::end(forms), [&](const Form& f) {
    return take({{f.x, x}, {f.y, y}});
  });
  if (form == std::end(forms))
    throw ForeignError(at,
                       "the snapshot has no columns x and y; write them with "
                       "dump ID all custom N FILE id type x y z vx vy vz radius");
  isScaled_ = form->isScaled;
  if (take({{form->z, z}})) {
    dimensions_ = 3;
    take({{"vx", vx}, {"vy", vy}, {"vz", vz}});
    take({{"omegax", wx}, {"omegay", wy}, {"omegaz", wz}});
  } else {
    take({{"vx", vx}, {"vy", vy}});
    take({{"omegaz", wz}});
  }
  if (!take({{"radius", size}}) && take({{"diameter", size}})) radiusPerSize_ = 0.5;
  take({{"id", id}});
  take({{"type", species}});
  names_.clear();
}

/// Gives the columns of these names their places, where all are there.
bool LammpsColumns::take(std::initializer_list<std::pair<std::string_view, Place>> columns) {
  const auto find = [&](std::string_view name) { return std::find(names_.begin(), names_.end(), name); };
  for (const auto& [name, place] : columns)
    if (find(name) == names_.end()) return false;
  for (const auto& [name, place] : columns) {
    places_[static_cast<std::size_t>(find(name) - names_.begin())] = place;
    has_[place] = true;
  }
  return true;
}

ForeignFrame LammpsColumns::read(std::string_view rows, std::size_t count, const ForeignBox& box,
                                 const SourceLocation& first) const {
  ForeignFrame frame;
  frame.position.reserve(count);
  if (has_[vx]) frame.velocity.reserve(count);
  if (has_[wz]) frame.angularVelocity.reserve(count);
  if (has_[size]) frame.radius.reserve(count);
  if (has_[species]) frame.species.reserve(count);
  if (has_[id]) frame.id.reserve(count);
  std::array<double, id> number{};
  WordReader words(rows, first);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Place place : places_) {
      if (!words.findInLine())
        throw ForeignError(words.at(), "the row has fewer columns than its snapshot's header");
      if (place < id)
        number[place] = words.number<double>();
      else if (place == unused)
        words.word();
      else
        (place == id ? frame.id : frame.species).push_back(words.number<std::int64_t>());
    }
    if (isScaled_)
      for (int axis = 0; axis < dimensions_; ++axis) {
        double& s = number[x + axis];
        s = box.low[axis] + s * (box.high[axis] - box.low[axis]);
        if (!std::isfinite(s)) throw ForeignError(words.at(), "the particle is infinitely far from its box");
      }
    frame.position.push_back({number[x], number[y], number[z]});
    if (has_[vx]) frame.velocity.push_back({number[vx], number[vy], number[vz]});
    if (has_[wz]) frame.angularVelocity.push_back({number[wx], number[wy], number[wz]});
    if (has_[size]) frame.radius.push_back(number[size] * radiusPerSize_);
    words.endLine();
  }
  return frame;
}

}  // namespace bedmix
