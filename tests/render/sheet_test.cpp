// SPDX-License-Identifier: MIT
#include "render/sheet.h"

#include "render/colors.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace bedmix {
namespace {

FramePtr share(Frame frame) { return std::make_shared<const Frame>(std::move(frame)); }

/// A bed full of one species.
FramePtr uniform(bool black, double time) {
  Frame frame = test::movingFrame(test::flatBed(), time);
  std::fill(frame.species.begin(), frame.species.end(), black ? 1 : 0);
  return share(std::move(frame));
}

/// A sheet of one run.
Result<Image> sheetOf(const Scene& scene, std::vector<FramePtr> frames, const Style& style = sheetLayers) {
  return drawSheet(std::vector<SheetRun>{{&scene, std::move(frames), {}}}, style);
}

/// Pixels of this colour between two columns.
int count(const Image& image, Rgba color, int from, int to) {
  int found = 0;
  for (int y = 0; y < image.size.height; ++y)
    for (int x = from; x < to; ++x) found += image.at(x, y) == color;
  return found;
}

TEST(Sheet, ShowsItsPanelsInOrder) {
  const std::vector<FramePtr> frames{uniform(true, 0.0), uniform(false, 0.5), uniform(true, 1.0)};
  const Result<Image> sheet = sheetOf(test::flatBed(), frames);
  ASSERT_TRUE(sheet);
  const int third = sheet->size.width / 3;
  for (int panel = 0; panel < 3; ++panel) {
    const int green = count(*sheet, restColor, panel * third, (panel + 1) * third);
    if (panel == 1)
      EXPECT_GT(green, third * third / 2);
    else
      EXPECT_EQ(green, 0);
  }
}

TEST(Sheet, OfNineTimesFillsAPageInOneRow) {
  std::vector<FramePtr> frames;
  for (int i = 0; i < 9; ++i) frames.push_back(uniform(true, i));
  const Result<Image> nine = sheetOf(test::flatBed(), frames);
  ASSERT_TRUE(nine);
  EXPECT_NEAR(nine->size.width, 190.0 / 25.4 * sheetDpi, 2.0);
  for (int i = 0; i < 9; ++i) frames.push_back(uniform(false, i));
  const Result<Image> eighteen = sheetOf(test::flatBed(), frames);
  ASSERT_TRUE(eighteen);
  EXPECT_EQ(eighteen->size.width, nine->size.width);
  EXPECT_GT(eighteen->size.height, 1.8 * nine->size.height);
}

TEST(Sheet, IsCroppedToWhatTheParticlesReach) {
  const auto heightWith = [](float y) {
    const std::vector<FramePtr> frames{share(test::particlesAt({{0.05f, 0.01f}}, {})),
                                       share(test::particlesAt({{0.05f, y}}, {}))};
    return sheetOf(test::flatBed(), frames)->size.height;
  };
  EXPECT_LT(heightWith(0.1f), heightWith(0.2f));
  EXPECT_EQ(heightWith(5.0f), heightWith(0.9f));  // thrown far above: the usual view
}

TEST(Sheet, HasAWhiteMargin) {
  const Result<Image> sheet = sheetOf(test::inclinedBed(), std::vector<FramePtr>(5, uniform(true, 0.25)));
  ASSERT_TRUE(sheet);
  for (int x = 0; x < sheet->size.width; ++x) {
    EXPECT_EQ(sheet->at(x, 0), white);
    EXPECT_EQ(sheet->at(x, sheet->size.height - 1), white);
  }
  for (int y = 0; y < sheet->size.height; ++y) {
    EXPECT_EQ(sheet->at(0, y), white);
    EXPECT_EQ(sheet->at(sheet->size.width - 1, y), white);
  }
}

TEST(Sheet, IsTheSameBytesTwice) {
  const std::vector<FramePtr> frames(2, share(test::movingFrame(test::inclinedBed())));
  EXPECT_EQ(sheetOf(test::inclinedBed(), frames)->rgba, sheetOf(test::inclinedBed(), frames)->rgba);
}

TEST(Sheet, OfNothingIsAProblem) {
  EXPECT_FALSE(drawSheet({}));
  EXPECT_FALSE(sheetOf(test::flatBed(), {}));
  const std::vector<FramePtr> frames{share(test::particlesAt({}, {{0.01f, 0.01f}}))};
  EXPECT_FALSE(sheetOf(test::flatBed(), frames, {Layer::voidage}));  // the frame has no gas
}

TEST(Sheet, OfTwoRunsHasARowEach) {
  const Scene flat = test::flatBed(), inclined = test::inclinedBed();
  const std::vector<FramePtr> black(3, uniform(true, 0.0)), green(3, uniform(false, 0.0));
  const Image one = *sheetOf(flat, black);
  const Image two =
      *drawSheet(std::vector<SheetRun>{{&flat, black, "(a) one"}, {&inclined, green, "(b) other"}});
  EXPECT_EQ(two.size.width, one.size.width);
  EXPECT_GT(two.size.height, 1.8 * one.size.height);
  const auto greenRows = [&](int from, int to) {
    int found = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < two.size.width; ++x) found += two.at(x, y) == restColor;
    return found;
  };
  EXPECT_EQ(greenRows(0, two.size.height / 3), 0);
  EXPECT_GT(greenRows(two.size.height * 2 / 3, two.size.height), 10000);
}

TEST(Sheet, ShowsAllRunsAtOneScale) {
  Scene wide = test::flatBed();
  wide.bed.width *= 3.0;
  const Scene narrow = test::flatBed();
  const FramePtr drop = share(test::particlesAt({}, {{0.03f, 0.01f}}));
  const auto greenIn = [&](const std::vector<SheetRun>& runs) {
    const Image image = *drawSheet(runs, {Layer::particles});
    int found = 0;
    for (int y = 0; y < image.size.height; ++y)
      for (int x = 0; x < image.size.width; ++x) found += image.at(x, y) == restColor;
    return found;
  };
  const int alone = greenIn({{&wide, {drop, drop}, {}}});
  EXPECT_GT(alone, 20);
  // Two of the same size more, not larger ones.
  EXPECT_NEAR(greenIn({{&wide, {drop, drop}, {}}, {&narrow, {drop, drop}, {}}}), 2 * alone, 0.2 * alone);
}

TEST(Sheet, CutsATitleThatIsTooLongForThePage) {
  const Scene scene = test::flatBed();
  const SheetRun run{&scene, std::vector<FramePtr>(2, uniform(true, 0.0)), std::string(500, 'W')};
  const Image image = *drawSheet(std::vector<SheetRun>{run});
  EXPECT_NEAR(image.size.width, 190.0 / 25.4 * sheetDpi, 2.0);
  for (int y = 0; y < image.size.height; ++y) EXPECT_EQ(image.at(image.size.width - 10, y), white) << y;
}

TEST(Sheet, ExplainsWhatItsCaptionCannot) {
  const std::vector<FramePtr> frames(4, share(test::movingFrame(test::flatBed())));
  const Size plain = sheetOf(test::flatBed(), frames)->size;
  const Size arrows =
      sheetOf(test::flatBed(), frames, {Layer::particles, Layer::velocity, Layer::walls})->size;
  EXPECT_EQ(arrows.width, plain.width);
  EXPECT_GT(arrows.height, plain.height + 50);
}

TEST(Sheet, ColoursByStartAreThoseOfTheHistory) {
  const Scene scene = test::flatBed();
  Style style{Layer::particles};
  style.color = ParticleColor::strips;
  const FramePtr start = share(test::particlesAt({{0.01f, 0.01f}, {0.09f, 0.01f}}, {}));
  const FramePtr swapped = share(test::particlesAt({{0.09f, 0.01f}, {0.01f, 0.01f}}, {}, 1.0));
  History history(scene, style);
  history.observe(*start);
  const auto sheet = [&](const FramePtr& frame) {
    return *drawSheet(std::vector<SheetRun>{{&scene, {frame}, {}, {history}}}, style);
  };
  EXPECT_NE(sheet(start).rgba, sheet(swapped).rgba);
  EXPECT_GT(sheet(start).size.width,
            2 * sheetOf(scene, {start}, {Layer::particles})->size.width - 100);  // legend
}

TEST(FramesAt, TakesTheLastFrameAtOrBeforeEachTime) {
  const std::vector<double> times{0.0, 0.1, 0.2, 3 * 0.1, 0.4, 0.5};
  const auto indices = framesAt(times, std::vector{0.3, 0.0, 0.15, 0.54});
  ASSERT_TRUE(indices);
  EXPECT_EQ(*indices, (std::vector<std::size_t>{3, 0, 1, 5}));
}

TEST(FramesAt, RefusesTimesOutsideTheRun) {
  const std::vector<double> times{0.1, 0.2, 0.3, 0.4, 0.5};
  const auto none = framesAt(times, std::vector{0.0, 0.2, 0.7, std::nan("")});
  ASSERT_EQ(none.problems.size(), 3u);
  EXPECT_NE(none.problems[1].message.find("0.7"), std::string::npos);
  EXPECT_NE(none.problems[1].message.find("0.1 to 0.5 s"), std::string::npos);
  EXPECT_TRUE(framesAt(std::vector{2.0}, std::vector{2.0}));  // of a run of one frame
  EXPECT_FALSE(framesAt(std::vector{2.0}, std::vector{2.1}));
}

TEST(SheetTimes, AreThePapersAsFarAsTheRunGoes) {
  EXPECT_EQ(defaultSheetTimes(10.0), (std::vector{0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}));
  EXPECT_EQ(defaultSheetTimes(2.0), (std::vector{0.0, 0.5, 1.0, 2.0}));
  EXPECT_EQ(defaultSheetTimes(0.04), (std::vector{0.0, 0.01, 0.02, 0.03, 0.04}));
}

}  // namespace
}  // namespace bedmix
