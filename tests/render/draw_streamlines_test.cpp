// SPDX-License-Identifier: MIT
#include "render/draw_streamlines.h"

#include "engine/core/gas_grid.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace bedmix {
namespace {

/// Gas velocity of the open cells by the middle of the cell.
Frame withVelocity(const Scene& scene, const std::function<Vec2(Vec2)>& velocity) {
  const GasGrid grid = makeGasGrid(scene);
  Frame frame = test::movingFrame(scene);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 middle{grid.x[column] + 0.5 * grid.dx(column), grid.y[row] + 0.5 * grid.dy(row)};
      frame.gas.velocity[grid.cell(column, row)] =
          grid.open(column, row) ? toFloat(velocity(middle)) : Vec2f{};
    }
  return frame;
}

TEST(Streamlines, OfUniformFlowAreStraightFromFloorToOutlet) {
  const Scene scene = test::flatBed();
  const auto lines = gasStreamlines(withVelocity(scene, [](Vec2) { return Vec2{0.0, 2.0}; }), scene);
  ASSERT_EQ(lines.size(), 8u);  // one a column of the gas grid
  for (std::size_t n = 0; n < lines.size(); ++n) {
    for (const Vec2& p : lines[n]) EXPECT_NEAR(p.x, 0.006 + 0.012 * static_cast<double>(n), 1e-9);
    EXPECT_LT(lines[n].front().y, 0.002);
    EXPECT_GT(lines[n].back().y, 0.418);
  }
}

TEST(Streamlines, OfAVortexKeepTheirRadius) {
  const Scene scene = test::flatBed();
  const Vec2 centre{0.048, 0.09};
  const auto turning = [&](Vec2 p) { return Vec2{centre.y - p.y, p.x - centre.x}; };
  const auto lines = gasStreamlines(withVelocity(scene, turning), scene);
  std::size_t checked = 0;
  for (const auto& line : lines) {
    const double radius = norm(line.front() - centre);
    for (const Vec2& p : line) {
      if (norm(line.front() - centre) > 0.03) break;
      EXPECT_NEAR(norm(p - centre), radius, 0.02 * radius);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100u);
}

TEST(Streamlines, KeepTheirDistanceAndEndAtBlockedCells) {
  const Scene scene = test::inclinedBed();
  const GasGrid grid = makeGasGrid(scene);
  const auto lines = gasStreamlines(withVelocity(scene, [](Vec2) { return Vec2{0.3, -1.0}; }), scene);
  ASSERT_GE(lines.size(), 5u);
  for (std::size_t a = 0; a < lines.size(); ++a)
    for (const Vec2& p : lines[a]) {
      const int column = std::min(static_cast<int>(p.x / 0.012), 7);
      EXPECT_GE(p.y, grid.y[static_cast<std::size_t>(grid.lowestRow[static_cast<std::size_t>(column)])]);
      for (std::size_t b = 0; b < a; ++b)
        for (const Vec2& q : lines[b]) ASSERT_GE(norm(p - q), 0.49 * 0.012);
    }
}

TEST(Streamlines, OfGasAtRestAreNone) {
  const Scene scene = test::flatBed();
  EXPECT_TRUE(gasStreamlines(withVelocity(scene, [](Vec2) { return Vec2{}; }), scene).empty());
}

TEST(Streamlines, HaveAHeadInTheMiddlePointingDownstream) {
  const Scene scene = test::flatBed();
  const DrawList list = test::drawn(scene,
                                    withVelocity(scene,
                                                 [](Vec2) {
                                                   return Vec2{0.0, 2.0};
                                                 }),
                                    {Layer::streamlines});
  int heads = 0;
  for (const Line& line : list.lines)
    if (line.head > 0.0f && line.color == gasColor) {
      ++heads;
      EXPECT_LT(line.to.y, line.from.y);
      EXPECT_NEAR(test::metres(line.to).y, 0.21, 0.002);
    }
  EXPECT_EQ(heads, 8);
}

}  // namespace
}  // namespace bedmix
