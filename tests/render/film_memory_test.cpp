// SPDX-License-Identifier: MIT
#include "render/film_sink.h"
#include "tests/bench/memory.h"
#include "tests/render/bed.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#ifdef __SANITIZE_ADDRESS__
// What is freed would else be kept for a while, and counted.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=1"; }
#endif

namespace bedmix {
namespace {

constexpr int early = 1000;

/// Shows so many frames of one, each a picture of the film.
void show(FilmSink& sink, Frame frame, int from, int to) {
  const std::vector<Vec2f> rest = frame.position;
  for (int n = from; n < to; ++n) {
    frame.step = n;
    frame.time = 0.02 * n;
    for (std::size_t i = 0; i < rest.size(); ++i)
      frame.position[i].y = rest[i].y + 0.004f * static_cast<float>(std::sin(0.1 * n));
    sink.accept(frame);
  }
}

class FilmMemory : public ::testing::TestWithParam<std::string> {};

TEST_P(FilmMemory, DoesNotGrowWithLength) {
  const int pictures = GetParam() == "long.mp4" ? 100000 : 20000;
  const test::TempFolder folder;
  Scene scene = test::gaslessBed();
  scene.particles.count = 20;
  scene.particles.diameter = 0.016;
  const Frame frame = test::movingFrame(scene);
  Result<FilmSink> sink = FilmSink::create(scene, folder / GetParam().c_str(),
                                           {{{64, 64}, {Layer::particles, Layer::walls}, 1}, 50.0});
  ASSERT_TRUE(sink) << sink.problems[0].message;
  show(*sink, frame, 0, early);
  bench::forgetPeakMemory();
  show(*sink, frame, early, 2 * early);
  const double before = bench::peakMemory();
  show(*sink, frame, 2 * early, pictures);
  const double after = bench::peakMemory();
  ASSERT_TRUE(sink->finish());
  EXPECT_EQ(sink->pictures(), pictures);
  EXPECT_LT(after, 1.05 * before);
  // An MP4 tells where each picture lies, and finish() gathers that.
  constexpr double bytesPerPicture = 250.0;
  EXPECT_LT(bench::peakMemory(), 1.05 * before + bytesPerPicture * pictures);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilmMemory, ::testing::Values("long.mp4", "long.gif", "long.mkv"));

}  // namespace
}  // namespace bedmix
