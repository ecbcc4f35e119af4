// SPDX-License-Identifier: MIT
#include "engine/coupling/grid_axis.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

GridAxis::GridAxis(const std::vector<double>& faces) : faces_(faces) {
  double smallest = faces.back();
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    smallest = std::min(smallest, faces[i + 1] - faces[i]);
    centres_.push_back(0.5 * (faces[i] + faces[i + 1]));
    perSize_.push_back(1.0 / (faces[i + 1] - faces[i]));
  }
  for (std::size_t i = 0; i + 1 < centres_.size(); ++i)
    perSpacing_.push_back(1.0 / (centres_[i + 1] - centres_[i]));
  const auto bins = static_cast<int>(std::ceil(faces.back() / smallest));
  binsPerLength_ = bins / faces.back();
  int cell = 0;
  for (int bin = 0; bin < bins; ++bin) {
    while (faces[cell + 1] <= bin / binsPerLength_) ++cell;
    cellOfBin_.push_back(cell);
  }
}

int GridAxis::cellAt(double at) const {
  const double bin = std::clamp(at * binsPerLength_, 0.0, static_cast<double>(cellOfBin_.size() - 1));
  int cell = cellOfBin_[static_cast<std::size_t>(bin)];
  const int last = static_cast<int>(centres_.size()) - 1;
  while (cell < last && at >= faces_[cell + 1]) ++cell;
  while (cell > 0 && at < faces_[cell]) --cell;
  return cell;
}

GridAxis::Pair GridAxis::overlap(double at, double radius) const {
  const double low = at - radius;
  const int cell = cellAt(low);
  if (cell + 1 == static_cast<int>(centres_.size())) return {cell, cell, 1.0};
  return {cell, cell + 1, std::min(1.0, (faces_[cell + 1] - low) / (2.0 * radius))};
}

GridAxis::Interpolation GridAxis::interpolate(double at) const {
  const int cell = cellAt(at);
  Interpolation between;
  between.faces = {cell, cell + 1, std::clamp((faces_[cell + 1] - at) * perSize_[cell], 0.0, 1.0)};
  const int first = at < centres_[cell] ? cell - 1 : cell;
  if (first < 0)
    between.centres = {0, 0, 1.0};
  else if (first + 1 == static_cast<int>(centres_.size()))
    between.centres = {first, first, 1.0};
  else
    between.centres = {first, first + 1, (centres_[first + 1] - at) * perSpacing_[first]};
  return between;
}

}  // namespace bedmix
