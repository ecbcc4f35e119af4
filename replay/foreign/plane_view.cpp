// SPDX-License-Identifier: MIT
#include "replay/foreign/plane_view.h"

#include <algorithm>

namespace bedmix {

void PlaneBox::include(Vec2 at) {
  low = {std::min(low.x, at.x), std::min(low.y, at.y)};
  high = {std::max(high.x, at.x), std::max(high.y, at.y)};
}

// Right and up are not always the first two axes of a right-handed system: x and z have -y towards the
// viewer.
PlaneView::PlaneView(ViewPlane plane)
    : right_(plane == ViewPlane::yz ? 1 : 0),
      up_(plane == ViewPlane::xy ? 1 : 2),
      away_(3 - right_ - up_),
      handedness_(plane == ViewPlane::xz ? -1.0 : 1.0) {}

ForeignBox boxAround(const std::vector<Vec3d>& positions) {
  ForeignBox box{positions.front(), positions.front()};
  for (const Vec3d& at : positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], at[k]);
      box.high[k] = std::max(box.high[k], at[k]);
    }
  }
  return box;
}

ViewPlane flattestPlane(const ForeignBox& box) {
  const auto thickness = [&](std::size_t k) { return box.high[k] - box.low[k]; };
  ViewPlane flattest = ViewPlane::xz;
  if (thickness(2) < thickness(1)) flattest = ViewPlane::xy;
  if (thickness(0) < std::min(thickness(1), thickness(2))) flattest = ViewPlane::yz;
  return flattest;
}

}  // namespace bedmix
