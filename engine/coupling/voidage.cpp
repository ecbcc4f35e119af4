// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage.h"

#include <algorithm>
#include <limits>

namespace bedmix {

namespace {

/// Depth below an open top over which the coupling fades, in diameters: long enough that a rising plug leaves
/// the gas grid without a jump in voidage, short against the freeboard.
constexpr double taperDiameters = 5.0;

}  // namespace

VoidageField::VoidageField(const Scene& scene, const GasGrid& grid)
    : grid_(grid),
      columns_(grid.x),
      rows_(grid.y),
      radius_(0.5 * scene.particles.diameter),
      particleVolume_(bedmix::particleVolume(scene)),
      // Against a lid the gas holds particles at the very top; nothing fades there.
      taperFrom_(scene.bed.top == BedTop::open ? grid.y.back() - taperDiameters * scene.particles.diameter
                                               : std::numeric_limits<double>::infinity()),
      top_(grid.y.back()),
      solids_(grid.cells()),
      voidage_(grid.cells(), 1.0) {}

double VoidageField::coupling(double y) const {
  if (y <= taperFrom_) return 1.0;
  if (y >= top_) return 0.0;
  const double s = (top_ - y) / (top_ - taperFrom_);
  return s * s * (3.0 - 2.0 * s);
}

void VoidageField::update(std::span<const double> x, std::span<const double> y) {
  shares_.resize(x.size());
  std::fill(solids_.begin(), solids_.end(), 0.0);
  aboveGrid_ = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const GridAxis::Pair column = columns_.overlap(x[i], radius_), row = rows_.overlap(y[i], radius_);
    const auto at = [&](int c, int r) {
      return static_cast<std::int32_t>(grid_.cell(c, std::max(r, grid_.lowestRow[c])));
    };
    VolumeShares& s = shares_[i];
    s.coupling = coupling(y[i]);
    s.cell = {at(column.first, row.first), at(column.second, row.first), at(column.first, row.second),
              at(column.second, row.second)};
    const double left = s.coupling * column.share, right = s.coupling - left;
    s.share = {left * row.share, right * row.share, left * (1.0 - row.share), right * (1.0 - row.share)};
    for (int k = 0; k < 4; ++k) solids_[s.cell[k]] += s.share[k];
    aboveGrid_ += y[i] > top_;
  }
  for (int r = 0; r < grid_.rows; ++r)
    for (int c = 0; c < grid_.columns; ++c) {
      const std::size_t cell = grid_.cell(c, r);
      voidage_[cell] = 1.0 - solids_[cell] * particleVolume_ / grid_.volume(c, r);
    }
}

double VoidageField::lowest() const { return *std::min_element(voidage_.begin(), voidage_.end()); }

}  // namespace bedmix
