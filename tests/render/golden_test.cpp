// SPDX-License-Identifier: MIT
// Pictures as they were when somebody looked at them. After a change of looks that is meant, run
//   BEDMIX_UPDATE_GOLDEN=1 test_render --gtest_filter='Golden.*'
// look at tests/render/golden, and commit it.
#include "render/painter.h"
#include "render/png.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace bedmix {
namespace {

namespace fs = std::filesystem;

struct Difference {
  double mean = 0.0;       // of a channel, of 255
  double farPixels = 0.0;  // share of the pixels with a channel off by more than 16
  Image picture;           // white where alike
};

Difference compare(const Image& actual, const Image& expected) {
  Difference difference;
  difference.picture.resize(actual.size);
  double sum = 0.0, off = 0.0;
  for (std::size_t i = 0; i < actual.rgba.size(); i += 4) {
    int worst = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const int d = std::abs(actual.rgba[i + c] - expected.rgba[i + c]);
      difference.picture.rgba[i + c] = static_cast<std::uint8_t>(255 - d);
      worst = std::max(worst, d);
      if (c < 3) sum += d;
    }
    off += worst > 16;
  }
  const double pixels = static_cast<double>(actual.rgba.size()) / 4.0;
  difference.mean = sum / (3.0 * pixels);
  difference.farPixels = off / pixels;
  return difference;
}

void expectGolden(const std::string& name, const Scene& scene, Layers layers) {
  Result<Painter> painter = Painter::create(scene, {{240, 420}, layers, 0});
  ASSERT_TRUE(painter);
  Image actual;
  ASSERT_TRUE(painter->paint(test::movingFrame(scene), actual));

  const fs::path file = fs::path(GOLDEN_FOLDER) / (name + ".png");
  if (std::getenv("BEDMIX_UPDATE_GOLDEN")) {
    ASSERT_TRUE(writePng(file, actual, {true, {}, {}}));
  }
  const Result<Image> expected = readPng(file);
  ASSERT_TRUE(expected) << expected.problems[0].message;
  ASSERT_EQ(actual.size, expected->size);
  const Difference difference = compare(actual, *expected);
  EXPECT_LE(difference.mean, 1.0);
  EXPECT_LE(difference.farPixels, 0.002);
  if (testing::Test::HasFailure()) {
    const fs::path folder = fs::absolute("golden_failures");
    fs::create_directories(folder);
    EXPECT_TRUE(writePng(folder / (name + "_actual.png"), actual));
    EXPECT_TRUE(writePng(folder / (name + "_expected.png"), *expected));
    EXPECT_TRUE(writePng(folder / (name + "_difference.png"), difference.picture));
    ADD_FAILURE() << "see " << folder;
  }
}

TEST(Golden, Particles) {
  expectGolden("particles", test::flatBed(), {Layer::particles, Layer::walls, Layer::hud});
}

TEST(Golden, VelocityAndSampling) {
  expectGolden("velocity_sampling", test::flatBed(),
               {Layer::velocity, Layer::sampling, Layer::walls, Layer::hud});
}

TEST(Golden, GasAndVoidageOnTheIncline) {
  expectGolden("gas_voidage", test::inclinedBed(), {Layer::gas, Layer::voidage, Layer::walls, Layer::hud});
}

}  // namespace
}  // namespace bedmix
