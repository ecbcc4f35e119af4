// SPDX-License-Identifier: MIT
#include "render/painter.h"

#include "render/colors.h"
#include "render/layout.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

constexpr Layers noHud{Layer::particles, Layer::walls};

Image painted(const Scene& scene, const Frame& frame, const PaintOptions& options) {
  Result<Painter> painter = Painter::create(scene, options);
  Image image;
  EXPECT_TRUE(painter && painter->paint(frame, image));
  return image;
}

TEST(Painter, PutsColoursWhereTheParticlesAre) {
  const Scene scene = test::gaslessBed();
  const Frame frame = test::particlesAt({{0.02f, 0.05f}}, {{0.07f, 0.30f}});
  const Size size{400, 800};
  const Image image = painted(scene, frame, {size, noHud, 0});
  const Camera camera = layoutPicture(scene, size, noHud).camera;
  const auto pixel = [&](Vec2f metres) {
    const Vec2f at = camera.toPixel(metres);
    return image.at(static_cast<int>(at.x), static_cast<int>(at.y));
  };
  EXPECT_EQ(pixel(frame.position[0]), tracerColor);
  EXPECT_EQ(pixel(frame.position[1]), restColor);
  EXPECT_EQ(pixel({0.02f, 0.30f}), white);
  EXPECT_EQ(pixel({-0.0012f, 0.2f}), wallColor);
}

TEST(Painter, SmoothsTheEdgesOfDiscsByTheAreaTheyCover) {
  Scene scene = test::gaslessBed();
  scene.particles.diameter = 0.05;
  const Frame frame = test::particlesAt({{0.048f, 0.2f}}, {});
  const Size size{400, 800};
  const Image image = painted(scene, frame, {size, Layers{Layer::particles}, 0});
  const float radius = layoutPicture(scene, size, {Layer::particles}).camera.length(0.025);
  double ink = 0.0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) ink += 1.0 - image.at(x, y).r / 255.0;
  EXPECT_NEAR(ink / (3.14159265 * radius * radius), 1.0, 2e-3);
}

TEST(Painter, GivesTheSameBytesForTheSameFrame) {
  const Scene scene = test::inclinedBed();
  const Frame frame = test::movingFrame(scene), other = test::movingFrame(test::flatBed(), 0.7);
  const PaintOptions options{
      {320, 480}, {Layer::particles, Layer::gas, Layer::pressure, Layer::walls, Layer::hud}, 0};
  Result<Painter> painter = Painter::create(scene, options);
  ASSERT_TRUE(painter);
  Image first, between, again;
  ASSERT_TRUE(painter->paint(frame, first));
  ASSERT_TRUE(painter->paint(other, between));
  ASSERT_TRUE(painter->paint(frame, again));
  EXPECT_EQ(first.rgba, again.rgba);
  EXPECT_NE(first.rgba, between.rgba);
  EXPECT_EQ(first.rgba, painted(scene, frame, options).rgba);
}

TEST(Painter, TwoPaintersDoNotDisturbEachOther) {
  const Scene flat = test::flatBed(), inclined = test::inclinedBed();
  const Frame a = test::movingFrame(flat), b = test::movingFrame(inclined);
  const Image aloneA = painted(flat, a, {{200, 400}, defaultLayers, 0});
  const Image aloneB = painted(inclined, b, {{333, 222}, defaultLayers, 0});
  Result<Painter> first = Painter::create(flat, {{200, 400}, defaultLayers, 0});
  Result<Painter> second = Painter::create(inclined, {{333, 222}, defaultLayers, 0});
  ASSERT_TRUE(first && second);
  Image imageA, imageB;
  ASSERT_TRUE(first->paint(a, imageA));
  ASSERT_TRUE(second->paint(b, imageB));
  ASSERT_TRUE(first->paint(a, imageA));
  EXPECT_EQ(imageA.rgba, aloneA.rgba);
  EXPECT_EQ(imageB.rgba, aloneB.rgba);
}

TEST(Painter, DrawsOddAndTinySizes) {
  const Scene scene = test::flatBed();
  for (const Size size : {Size{641, 481}, Size{17, 23}, Size{16, 16}, Size{1000, 16}}) {
    const Image image = painted(scene, test::movingFrame(scene), {size, defaultLayers, 0});
    EXPECT_EQ(image.size, size);
    EXPECT_EQ(image.rgba.size(), 4u * size.width * size.height);
  }
}

TEST(Painter, ChoosesAnEvenSizeByItself) {
  const Size size = defaultSize(test::flatBed());
  EXPECT_EQ(size.width % 2, 0);
  EXPECT_EQ(size.height % 2, 0);
  EXPECT_EQ(painted(test::flatBed(), test::movingFrame(test::flatBed()), {}).size, size);
}

TEST(Painter, ReadsSizes) {
  const Result<Size> size = parseSize("1280x720");
  ASSERT_TRUE(size);
  EXPECT_EQ(*size, (Size{1280, 720}));
  for (const char* wrong :
       {"", "1280", "1280x", "x720", "1280X720", "1280x720p", "-3x5", "15x720", "1280x16385"})
    EXPECT_FALSE(parseSize(wrong)) << wrong;
}

}  // namespace
}  // namespace bedmix
