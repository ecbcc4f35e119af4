// SPDX-License-Identifier: MIT
#include "render/draw_bubbles.h"

#include "engine/core/gas_grid.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace bedmix {
namespace {

/// Voidage of cells by the middle of the cell.
Frame withVoidage(const Scene& scene, const std::function<double(Vec2)>& voidage) {
  const GasGrid grid = makeGasGrid(scene);
  Frame frame;
  frame.gas = {std::vector<float>(grid.cells(), 1.0f), std::vector<float>(grid.cells()),
               std::vector<Vec2f>(grid.cells())};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const Vec2 middle{grid.x[column] + 0.5 * grid.dx(column), grid.y[row] + 0.5 * grid.dy(row)};
      frame.gas.voidage[grid.cell(column, row)] = static_cast<float>(voidage(middle));
    }
  return frame;
}

/// The lines without their rims, which come first.
std::vector<Line> contour(const Scene& scene, const Frame& frame, double level = 0.8) {
  Style style{Layer::bubbles};
  style.bubbleVoidage = level;
  const std::vector<Line> lines = test::drawn(scene, frame, style).lines;
  return {lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2), lines.end()};
}

TEST(Bubbles, ALinearFieldHasAStraightOutlineWhereItShouldBe) {
  const Scene scene = test::flatBed();
  // 0.4 at the floor, 1 at 0.42 m, steeper to the right.
  const auto voidage = [](Vec2 p) { return 0.4 + p.y / 0.7 + 2.0 * (p.x - 0.048); };
  double left = 1.0, right = 0.0;
  const std::vector<Line> lines = contour(scene, withVoidage(scene, voidage), 0.7);
  ASSERT_FALSE(lines.empty());
  for (const Line& line : lines)
    for (const Vec2f& end : {line.from, line.to}) {
      const Vec2 p = test::metres(end);
      // To the left of the first middles and to the right of the last ones it is level.
      const double x = std::clamp(p.x, 0.006, 0.090);
      EXPECT_NEAR(voidage({x, p.y}), 0.7, 1e-4);
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
  EXPECT_NEAR(left, 0.0, 1e-6);  // from wall to wall
  EXPECT_NEAR(right, 0.096, 1e-6);
}

TEST(Bubbles, ARoundOneIsClosed) {
  const Scene scene = test::flatBed();
  const auto voidage = [](Vec2 p) { return 1.0 - std::hypot(p.x - 0.048, p.y - 0.1) / 0.1; };
  const std::vector<Line> lines = contour(scene, withVoidage(scene, voidage));
  ASSERT_GE(lines.size(), 8u);
  for (const Line& line : lines) {
    const auto meets = [&](Vec2f end) {
      return std::count_if(lines.begin(), lines.end(), [&](const Line& other) {
        return norm(other.from - end) < 1e-2f || norm(other.to - end) < 1e-2f;
      });
    };
    EXPECT_EQ(meets(line.from), 2);
    EXPECT_EQ(meets(line.to), 2);
    const Vec2 p = test::metres(line.from);
    EXPECT_NEAR(std::hypot(p.x - 0.048, p.y - 0.1), 0.02, 0.004);
  }
}

TEST(Bubbles, ASaddlesMiddleDecidesWhatIsJoined) {
  const Scene scene = test::flatBed();
  const auto corners = [&](double high) {
    const GasGrid grid = makeGasGrid(scene);
    Frame frame = withVoidage(scene, [](Vec2) { return 0.5; });
    frame.gas.voidage[grid.cell(3, 5)] = frame.gas.voidage[grid.cell(4, 6)] = static_cast<float>(high);
    return frame;
  };
  const Vec2 middle{0.048, 0.072};  // of the four
  const auto nearest = [&](const std::vector<Line>& lines) {
    double least = 1.0;
    for (const Line& line : lines)
      least = std::min(least, norm(test::metres((line.from + line.to) * 0.5f) - middle));
    return least;
  };
  // Mean 0.75, above the level: one outline around both, which passes the middle further away.
  const std::vector<Line> joined = contour(scene, corners(1.0), 0.7);
  const std::vector<Line> apart = contour(scene, corners(1.0), 0.9);
  EXPECT_EQ(joined.size(), apart.size());
  EXPECT_NEAR(nearest(joined), 0.4 * 0.012 * std::sqrt(2.0), 2e-3);
  EXPECT_LT(nearest(apart), 0.6 * 0.012 * std::sqrt(2.0));
}

TEST(Bubbles, LeaveOutBlockedCells) {
  const Scene scene = test::inclinedBed();
  EXPECT_TRUE(contour(scene, withVoidage(scene, [](Vec2) { return 0.5; })).empty());
}

}  // namespace
}  // namespace bedmix
