// SPDX-License-Identifier: MIT
// Both sources of OpenGL are in app/packages.txt, so neither may be missing here.
#include "render/gl_context.h"

#include "render/painter.h"
#include "render/surface.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <thread>

namespace bedmix {
namespace {

constexpr Layers many{Layer::particles, Layer::velocity, Layer::sampling, Layer::gas,
                      Layer::pressure,  Layer::walls,    Layer::hud};
const PaintOptions options{{320, 480}, many, 0};

/// Whoever makes a painter gets this source's OpenGL as long as it lives.
class Using {
 public:
  explicit Using(GlSource source) { useGlSource(source); }
  ~Using() { useGlSource(GlSource::automatic); }
  Using(const Using&) = delete;
};

Result<Painter> painterWith(GlSource source, const Scene& scene) {
  const Using it(source);
  return Painter::create(scene, options);
}

Image painted(Painter& painter, const Frame& frame) {
  Image image;
  EXPECT_TRUE(painter.paint(frame, image));
  return image;
}

class EachSource : public testing::TestWithParam<GlSource> {};
INSTANTIATE_TEST_SUITE_P(Gl, EachSource, testing::Values(GlSource::osmesa, GlSource::egl),
                         [](const auto& instance) {
                           return std::string(glSourceNames[static_cast<std::size_t>(instance.param)]);
                         });

TEST_P(EachSource, SaysWhatItIs) {
  const Result<std::string> found = probeSurface(GetParam());
  ASSERT_TRUE(found) << found.problems[0].message;
  EXPECT_TRUE(found->starts_with(GetParam() == GlSource::egl ? "EGL, " : "OSMesa, ")) << *found;
  EXPECT_NE(found->find("llvmpipe"), std::string::npos) << *found;
}

TEST_P(EachSource, MovesBetweenThreads) {
  const Scene scene = test::inclinedBed();
  const Frame frame = test::movingFrame(scene);
  Result<Painter> painter = painterWith(GetParam(), scene);
  ASSERT_TRUE(painter);
  const Image here = painted(*painter, frame);
  Image there, gone;
  std::thread([&] { there = painted(*painter, frame); }).join();
  std::thread([moved = std::move(*painter), &gone, &frame]() mutable {
    gone = painted(moved, frame);
  }).join();
  EXPECT_EQ(here.rgba, there.rgba);
  EXPECT_EQ(here.rgba, gone.rgba);
}

TEST_P(EachSource, DrawsInTwoThreadsAtOnce) {
  const Scene scene = test::inclinedBed();
  const Frame frame = test::movingFrame(scene);
  Result<Painter> first = painterWith(GetParam(), scene), second = painterWith(GetParam(), scene);
  ASSERT_TRUE(first && second);
  const Image alone = painted(*first, frame);
  Image other;
  std::thread thread([&] {
    for (int i = 0; i < 20; ++i) other = painted(*second, frame);
  });
  Image own;
  for (int i = 0; i < 20; ++i) own = painted(*first, frame);
  thread.join();
  EXPECT_EQ(own.rgba, alone.rgba);
  EXPECT_EQ(other.rgba, alone.rgba);
}

TEST(GlSources, GiveTheSameBytes) {
  const Scene scene = test::inclinedBed();
  const Frame frame = test::movingFrame(scene), later = test::movingFrame(scene, 0.7);
  Result<Painter> osmesa = painterWith(GlSource::osmesa, scene), egl = painterWith(GlSource::egl, scene);
  ASSERT_TRUE(osmesa && egl);
  for (const Frame* shown : {&frame, &later, &frame})  // turn by turn, in one thread
    EXPECT_EQ(painted(*osmesa, *shown).rgba, painted(*egl, *shown).rgba);
}

TEST(GlSources, AutomaticIsOsmesaFirst) {
  EXPECT_EQ(glSource(), GlSource::automatic);
  EXPECT_EQ(*probeSurface(), *probeSurface(GlSource::osmesa));
}

}  // namespace
}  // namespace bedmix
