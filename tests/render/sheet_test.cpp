// SPDX-License-Identifier: MIT
#include "render/sheet.h"

#include "render/colors.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace bedmix {
namespace {

FramePtr share(Frame frame) { return std::make_shared<const Frame>(std::move(frame)); }

/// A bed full of one species.
FramePtr uniform(bool black, double time) {
  Frame frame = test::movingFrame(test::flatBed(), time);
  std::fill(frame.species.begin(), frame.species.end(), black ? 1 : 0);
  return share(std::move(frame));
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
  const Result<Image> sheet = drawSheet(test::flatBed(), frames);
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
  const Result<Image> nine = drawSheet(test::flatBed(), frames);
  ASSERT_TRUE(nine);
  EXPECT_NEAR(nine->size.width, 190.0 / 25.4 * sheetDpi, 2.0);
  for (int i = 0; i < 9; ++i) frames.push_back(uniform(false, i));
  const Result<Image> eighteen = drawSheet(test::flatBed(), frames);
  ASSERT_TRUE(eighteen);
  EXPECT_EQ(eighteen->size.width, nine->size.width);
  EXPECT_GT(eighteen->size.height, 1.8 * nine->size.height);
}

TEST(Sheet, IsCroppedToWhatTheParticlesReach) {
  const auto heightWith = [](float y) {
    const std::vector<FramePtr> frames{share(test::particlesAt({{0.05f, 0.01f}}, {})),
                                       share(test::particlesAt({{0.05f, y}}, {}))};
    return drawSheet(test::flatBed(), frames)->size.height;
  };
  EXPECT_LT(heightWith(0.1f), heightWith(0.2f));
  EXPECT_EQ(heightWith(5.0f), heightWith(0.9f));  // thrown far above: the usual view
}

TEST(Sheet, HasAWhiteMargin) {
  const Result<Image> sheet = drawSheet(test::inclinedBed(), std::vector<FramePtr>(5, uniform(true, 0.25)));
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
  EXPECT_EQ(drawSheet(test::inclinedBed(), frames)->rgba, drawSheet(test::inclinedBed(), frames)->rgba);
}

TEST(Sheet, OfNothingIsAProblem) {
  EXPECT_FALSE(drawSheet(test::flatBed(), {}));
  const std::vector<FramePtr> frames{share(test::particlesAt({}, {{0.01f, 0.01f}}))};
  EXPECT_FALSE(drawSheet(test::flatBed(), frames, {Layer::voidage}));  // the frame has no gas
}

TEST(FramesAt, KeepsTheLastFrameAtOrBeforeEachTime) {
  FramesAt sink({0.3, 0.0, 0.15});
  for (int i = 0; i <= 5; ++i) sink.accept(test::particlesAt({}, {}, i * 0.1));
  const Result<std::vector<FramePtr>> frames = sink.frames();
  ASSERT_TRUE(frames);
  ASSERT_EQ(frames->size(), 3u);
  EXPECT_DOUBLE_EQ((*frames)[0]->time, 3 * 0.1);
  EXPECT_DOUBLE_EQ((*frames)[1]->time, 0.0);
  EXPECT_DOUBLE_EQ((*frames)[2]->time, 0.1);
}

TEST(FramesAt, RefusesTimesOutsideTheRun) {
  FramesAt sink({0.0, 0.2, 0.7});
  for (int i = 1; i <= 5; ++i) sink.accept(test::particlesAt({}, {}, i * 0.1));
  const Result<std::vector<FramePtr>> frames = sink.frames();
  ASSERT_EQ(frames.problems.size(), 2u);
  EXPECT_NE(frames.problems[1].message.find("0.7"), std::string::npos);
  EXPECT_NE(frames.problems[1].message.find("0.5"), std::string::npos);
  EXPECT_FALSE(FramesAt({0.0}).frames());  // of an empty run
}

TEST(SheetTimes, AreThePapersAsFarAsTheRunGoes) {
  EXPECT_EQ(defaultSheetTimes(10.0), (std::vector{0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}));
  EXPECT_EQ(defaultSheetTimes(2.0), (std::vector{0.0, 0.5, 1.0, 2.0}));
  EXPECT_EQ(defaultSheetTimes(0.04), (std::vector{0.0, 0.01, 0.02, 0.03, 0.04}));
}

}  // namespace
}  // namespace bedmix
