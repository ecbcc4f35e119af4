// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"
#include "replay/foreign/foreign_source.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace bedmix {

/// The plane a bed lies in: its first axis points right, its second one up.
enum class ViewPlane { xy, xz, yz };
inline constexpr std::array<std::string_view, 3> planeNames{"xy", "xz", "yz"};

/// An upright rectangle in a plane, m, in the coordinates of a file.
struct PlaneBox {
  Vec2 low, high;

  Vec2 size() const { return high - low; }
  bool holds(Vec2 at) const { return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y; }
  void include(Vec2 at);
};

/// How what lies in space is seen in a plane.
class PlaneView {
 public:
  explicit PlaneView(ViewPlane plane);

  Vec2 operator()(const Vec3d& v) const { return {v[right_], v[up_]}; }
  PlaneBox operator()(const ForeignBox& box) const { return {(*this)(box.low), (*this)(box.high)}; }
  /// Along the line of sight.
  double depth(const ForeignBox& box) const { return box.high[away_] - box.low[away_]; }
  /// Of a rotation, counter-clockwise as it is seen.
  double spin(const Vec3d& w) const { return handedness_ * w[away_]; }

 private:
  std::size_t right_, up_, away_;
  double handedness_;
};

/// The box around all positions, which are at least one.
ForeignBox boxAround(const std::vector<Vec3d>& positions);

/// The plane seen along the axis in which the box is thinnest; of equal ones y before z before x.
ViewPlane flattestPlane(const ForeignBox& box);

}  // namespace bedmix
