// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

#include <initializer_list>
#include <string_view>
#include <utility>

namespace bedmix {

/// What the columns of a LAMMPS dump mean, by the names behind "ITEM: ATOMS". Those of velocity and spin
/// count only where no component is missing. Failures throw ForeignError.
class LammpsColumns {
 public:
  LammpsColumns(std::string_view names, const SourceLocation& at);

  /// 3 where there is a column of z, else 2.
  int dimensions() const { return dimensions_; }
  /// Particles from `count` rows, the first of which is at `first`. Scaled coordinates are fractions of
  /// `box`.
  ForeignFrame read(std::string_view rows, std::size_t count, const ForeignBox& box,
                    const SourceLocation& first) const;

 private:
  /// Where a number of a row goes.
  enum Place { x, y, z, vx, vy, vz, wx, wy, wz, size, id, species, unused };

  bool take(std::initializer_list<std::pair<std::string_view, Place>> columns);

  std::vector<std::string_view> names_;  // until the constructor ends
  std::vector<Place> places_;
  std::array<bool, unused> has_{};
  int dimensions_ = 2;
  bool isScaled_ = false;
  double radiusPerSize_ = 1.0;
};

}  // namespace bedmix
