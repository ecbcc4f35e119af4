// SPDX-License-Identifier: MIT
// Pictures as they were when somebody looked at them. After a change of looks that is meant, run
//   BEDMIX_UPDATE_GOLDEN=1 test_render --gtest_filter='Golden.*'
// look at tests/render/golden, and commit it.
#include "render/painter.h"
#include "render/png.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

void expectGolden(const std::string& name, const Image& actual) {
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

/// Of the last frame, the others observed.
void expectGolden(const std::string& name, const Scene& scene, const Style& style,
                  const std::vector<Frame>& frames) {
  Result<Painter> painter = Painter::create(scene, {{240, 420}, style, 0});
  ASSERT_TRUE(painter) << painter.problems[0].message;
  for (const Frame& frame : frames) painter->observe(0, frame);
  Image actual;
  ASSERT_TRUE(painter->paint(frames.back(), actual));
  expectGolden(name, actual);
}

void expectGolden(const std::string& name, const Scene& scene, const Style& style) {
  expectGolden(name, scene, style, {test::movingFrame(scene)});
}

/// The moving frame's particles on their way through the bed, for a tenth of a second.
std::vector<Frame> stirredFrames(const Scene& scene) {
  std::vector<Frame> frames;
  for (int i = 0; i <= 20; ++i) {
    Frame& frame = frames.emplace_back(test::movingFrame(scene, 0.4 + 0.005 * i));
    const float share = static_cast<float>(i) / 20.0f;
    for (Vec2f& p : frame.position) {
      const float x = p.x, y = p.y;
      p.x += share * 8.0f * x * (0.096f - x) * std::sin(40.0f * y);
      p.y += share * 0.04f * (1.0f + std::sin(65.0f * x)) * y / 0.2f;
    }
  }
  return frames;
}

/// The moving frame's lattice pressed together, here more, there less.
Frame pressedFrame(const Scene& scene) {
  Frame frame = test::movingFrame(scene);
  const auto unevenness = static_cast<float>(0.005 * scene.particles.diameter);
  const auto inset = static_cast<float>(0.1 * scene.particles.diameter);
  for (Vec2f& p : frame.position) {
    p = p * 0.7995f + Vec2f{inset, inset};
    p += Vec2f{std::sin(900.0f * p.y) * std::sin(500.0f * p.x), std::sin(300.0f * p.x)} * unevenness;
  }
  return frame;
}

Style colored(ParticleColor color, std::int64_t classes = 6) {
  Style style;
  style.color = color;
  style.classes = classes;
  return style;
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

TEST(Golden, Pressure) {
  expectGolden("pressure", test::flatBed(), {Layer::pressure, Layer::particles, Layer::walls, Layer::hud});
}

TEST(Golden, GasSpeedAndStreamlines) {
  expectGolden("streamlines", test::inclinedBed(),
               {Layer::gasSpeed, Layer::streamlines, Layer::walls, Layer::hud});
}

TEST(Golden, Bubbles) {
  expectGolden("bubbles", test::flatBed(), {Layer::voidage, Layer::bubbles, Layer::walls, Layer::hud});
}

TEST(Golden, Trails) {
  Style style;
  style.layers.add(Layer::trails);
  style.trails = {300, 505, 700, 910};
  style.trailTime = 0.1;
  expectGolden("trails", test::flatBed(), style, stirredFrames(test::flatBed()));
}

TEST(Golden, Forces) {
  Scene scene = test::flatBed();
  scene.particles = {100, 0.012, 1500.0};
  expectGolden("forces", scene, {Layer::particles, Layer::forces, Layer::walls, Layer::hud},
               {pressedFrame(scene)});
}

TEST(Golden, CountsInCoarseCells) {
  Scene scene = test::flatBed();
  scene.sampling.columns = 2;
  scene.sampling.rows = 10;
  expectGolden("counts", scene, {Layer::particles, Layer::sampling, Layer::counts, Layer::walls, Layer::hud});
}

TEST(Golden, Flow) {
  expectGolden("flow", test::flatBed(), {Layer::flow, Layer::sampling, Layer::walls, Layer::hud});
}

Scene shortRun(Scene scene) {
  scene.time.duration = 0.2;
  return scene;
}

/// The stirred frames from t = 0 on, with tracer in the left half at first.
std::vector<Frame> mixedFrames(const Scene& scene, double speed) {
  std::vector<Frame> frames = stirredFrames(scene);
  for (std::size_t i = 0; i < frames.front().size(); ++i) {
    const std::uint8_t species = frames.front().position[i].x < 0.048f;
    for (Frame& frame : frames) frame.species[i] = species;
  }
  for (Frame& frame : frames) frame.time = (frame.time - 0.4) / speed;
  return frames;
}

TEST(Golden, CurveOfOneRun) {
  const Scene scene = shortRun(test::flatBed());
  expectGolden("curve", scene, {Layer::particles, Layer::walls, Layer::hud, Layer::curve},
               mixedFrames(scene, 1.0));
}

TEST(Golden, RunsSideBySide) {
  const std::vector<PaintedBed> beds{{shortRun(test::flatBed()), "even"},
                                     {shortRun(test::inclinedBed()), "inclined"}};
  const Style style{Layer::particles, Layer::walls, Layer::hud, Layer::curve};
  Result<Painter> painter = Painter::create(beds, {{640, 360}, style, 0});
  ASSERT_TRUE(painter) << painter.problems[0].message;
  std::vector<Frame> last;
  for (std::size_t bed = 0; bed < 2; ++bed) {
    const std::vector<Frame> frames = mixedFrames(beds[bed].scene, bed == 0 ? 1.0 : 2.0);
    for (const Frame& frame : frames) painter->observe(bed, frame);
    last.push_back(frames.back());
  }
  Image actual;
  const std::vector<const Frame*> shown{&last[0], &last[1]};
  ASSERT_TRUE(painter->paint(shown, actual));
  expectGolden("side_by_side", actual);
}

TEST(Golden, ColorSpeed) { expectGolden("color_speed", test::flatBed(), colored(ParticleColor::speed)); }

TEST(Golden, ColorSpin) {
  Scene scene = test::flatBed();
  scene.contacts.friction.emplace();
  expectGolden("color_spin", scene, colored(ParticleColor::spin));
}

TEST(Golden, ColorVoidage) {
  expectGolden("color_voidage", test::inclinedBed(), colored(ParticleColor::voidage));
}

TEST(Golden, ColorId) { expectGolden("color_id", test::flatBed(), colored(ParticleColor::id)); }

TEST(Golden, ColorHeight) {
  expectGolden("color_height", test::flatBed(), colored(ParticleColor::height, 5),
               stirredFrames(test::flatBed()));
}

TEST(Golden, ColorStrips) {
  expectGolden("color_strips", test::flatBed(), colored(ParticleColor::strips),
               stirredFrames(test::flatBed()));
}

TEST(Golden, DarkGround) {
  Style style{Layer::particles, Layer::velocity, Layer::gas, Layer::sampling, Layer::walls, Layer::hud};
  style.ground = {24, 28, 40};
  expectGolden("dark", test::inclinedBed(), style);
}

}  // namespace
}  // namespace bedmix
