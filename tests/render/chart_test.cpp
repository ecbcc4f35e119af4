// SPDX-License-Identifier: MIT
#include "render/chart.h"

#include "render/hud.h"
#include "render/layout.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace bedmix {
namespace {

MixingSample sampleAt(double time, std::optional<double> lacey, std::optional<double> ashton) {
  MixingSample sample;
  sample.time = time;
  sample.lacey = lacey;
  sample.ashton = ashton;
  return sample;
}

TEST(IndexCurve, KeepsSamplesInOrderOfTime) {
  IndexCurve curve;
  curve.observe(sampleAt(0.0, 0.1, {}));
  curve.observe(sampleAt(0.0, 0.9, {}));
  curve.observe(sampleAt(0.5, 0.2, 0.3));
  ASSERT_EQ(curve.points().size(), 2u);
  EXPECT_EQ(curve.points()[0].lacey, 0.1f);
  EXPECT_TRUE(std::isnan(curve.points()[0].ashton));
  EXPECT_EQ(curve.points()[1].ashton, 0.3f);
}

TEST(IndexCurve, StaysSmallOverALongRunAndEvenlySpaced) {
  IndexCurve curve;
  const int samples = 20 * static_cast<int>(IndexCurve::mostPoints);
  for (int i = 0; i < samples; ++i) curve.observe(sampleAt(0.5 * i, 1e-3 * i, {}));
  const auto& points = curve.points();
  EXPECT_LE(points.size(), IndexCurve::mostPoints);
  EXPECT_GE(points.size(), IndexCurve::mostPoints / 2);
  const float step = points[1].time - points[0].time;
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_EQ(points[i].time - points[i - 1].time, step);
  EXPECT_GT(points.back().time, 0.5f * static_cast<float>(samples) - 2.0f * step);
}

TEST(Chart, PutsPointsWhereTheirTimeAndIndexAre) {
  std::array curves{IndexCurve{}};
  curves[0].observe(sampleAt(0.0, 0.0, {}));
  curves[0].observe(sampleAt(5.0, 0.7, 1.4));
  curves[0].observe(sampleAt(10.0, 1.4, 0.7));
  const std::array names{std::string()};
  const Chart chart = indexChart(names, curves);
  ASSERT_EQ(chart.curves.size(), 2u);
  const Box box{100.0f, 50.0f, 500.0f, 350.0f};
  DrawList list, overlay;
  drawChart(list, overlay, box, chart, 10.0, 12.0f);
  const Box axes = chartAxes(box, 2, 12.0f);
  EXPECT_EQ(list.clip, axes);
  ASSERT_EQ(list.lines.size(), 3u);  // Lacey's two, and Ashton's one between the values that are defined
  EXPECT_FLOAT_EQ(list.lines[0].from.x, axes.left);
  EXPECT_FLOAT_EQ(list.lines[0].from.y, axes.bottom);
  EXPECT_FLOAT_EQ(list.lines[0].to.x, 0.5f * (axes.left + axes.right));
  EXPECT_NEAR(list.lines[0].to.y, 0.5f * (axes.top + axes.bottom), 1e-3f);
  EXPECT_NEAR(list.lines[1].to.y, axes.top, 1e-3f);
  EXPECT_FLOAT_EQ(list.lines[1].to.x, axes.right);
  EXPECT_NEAR(list.lines[2].from.y, axes.top, 1e-3f);
}

TEST(Chart, ComparesAshtonsIndexOfSeveralRuns) {
  const std::array<IndexCurve, 2> curves;
  const std::array names{std::string("even"), std::string("inclined")};
  const Chart chart = indexChart(names, curves);
  EXPECT_EQ(chart.title, "Ashton index");
  ASSERT_EQ(chart.curves.size(), 2u);
  EXPECT_EQ(chart.curves[1].label, "inclined");
  EXPECT_EQ(chart.curves[0].index, &IndexCurve::Point::ashton);
  EXPECT_NE(chart.curves[0].color, chart.curves[1].color);
}

TEST(Chart, KeepsItsTextsInItsBox) {
  std::array curves{IndexCurve{}};
  const std::array names{std::string()};
  for (const Size size : {Size{240, 420}, Size{1280, 720}, Size{720, 1280}, Size{641, 481}})
    for (const double until : {0.05, 1.5, 10.0, 3600.0}) {
      const Scene scene = test::flatBed();
      const PictureLayout layout = layoutPicture(std::span(&scene, 1), size, {Layer::hud, Layer::curve});
      DrawList list, overlay;
      drawChart(list, overlay, layout.chart, indexChart(names, curves), until, layout.em);
      Hud hud(layout.em);
      for (const UiVertex& v : hud.mesh(size, overlay.texts).vertices) {
        EXPECT_GE(v.at.x, layout.chart.left - 1.0f)
            << size.width << 'x' << size.height << ", " << until << " s";
        EXPECT_LE(v.at.x, layout.chart.right + 1.0f);
        EXPECT_GE(v.at.y, layout.chart.top - 1.0f);
        EXPECT_LE(v.at.y, layout.chart.bottom + 1.0f);
      }
    }
}

TEST(Layout, PutsBedsSideBySideToOneScale) {
  Scene wide = test::gaslessBed();
  wide.bed.width *= 2.0;
  const std::array scenes{test::flatBed(), test::inclinedBed(), wide};
  for (const Size size : {Size{1280, 720}, Size{720, 1280}, Size{1920, 500}})
    for (const Layers layers : {defaultLayers, Layers{Layer::particles, Layer::hud, Layer::curve}}) {
      const PictureLayout layout = layoutPicture(scenes, size, layers);
      ASSERT_EQ(layout.beds.size(), 3u);
      float left = 0.0f;
      for (std::size_t i = 0; i < 3; ++i) {
        const Camera& camera = layout.beds[i].camera;
        EXPECT_FLOAT_EQ(camera.scale, layout.beds[0].camera.scale);
        EXPECT_GE(camera.origin.x, left);
        left = camera.origin.x + camera.length(scenes[i].bed.width);
        EXPECT_LE(left, static_cast<float>(size.width));
        EXPECT_GE(camera.toPixel(Vec2{0.0, viewHeight(scenes[i])}).y, layout.beds[i].view.top - 0.5f);
        if (layers.has(Layer::curve)) {
          EXPECT_TRUE(layout.chart.left >= left || layout.chart.top >= camera.origin.y);
        }
      }
      EXPECT_EQ(layout.chart.width() > 0.0f, layers.has(Layer::curve));
    }
}

}  // namespace
}  // namespace bedmix
