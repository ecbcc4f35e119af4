// SPDX-License-Identifier: MIT
#include "render/png.h"

#include "render/png_info.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

/// Every pixel another colour, in an odd size.
Image chart() {
  Image image;
  image.resize({37, 21});
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const auto n = static_cast<std::uint8_t>(i / 4);
    const Rgba color{n, static_cast<std::uint8_t>(255 - n), static_cast<std::uint8_t>(7 * n), 255};
    std::copy_n(&color.r, 4, &image.rgba[i]);
  }
  return image;
}

TEST(Png, KeepsEveryPixel) {
  const test::TempFolder folder;
  for (const bool small : {false, true}) {
    ASSERT_TRUE(writePng(folder / "chart.png", chart(), {small, {}, {}}));
    const Result<Image> read = readPng(folder / "chart.png");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->size, chart().size);
    EXPECT_EQ(read->rgba, chart().rgba);
  }
}

TEST(Png, HoldsTextsAndResolution) {
  const test::TempFolder folder;
  ASSERT_TRUE(writePng(folder / "chart.png", chart(), {true, {{"Time", "0.5 s"}, {"Step", "50000"}}, 300.0}));
  const std::string bytes = test::bytesOf(folder / "chart.png");
  EXPECT_NE(bytes.find(std::string("tEXtTime\0000.5 s", 14)), std::string::npos);
  EXPECT_NE(bytes.find("tEXtStep"), std::string::npos);
  // 300 dpi are 11811 = 0x2E23 pixels per metre both ways; the unit is 1, a metre.
  EXPECT_NE(bytes.find(std::string("pHYs\0\0\x2e\x23\0\0\x2e\x23\1", 13)), std::string::npos);
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(Png, SaysWhatItIsWithoutItsPixels) {
  const test::TempFolder folder;
  const PngText text{{"Title", ""}, {"Step", "50000"}};
  ASSERT_TRUE(writePng(folder / "chart.png", chart(), {false, text, 300.0}));
  const Result<PngInfo> info = readPngInfo(folder / "chart.png");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->size, chart().size);
  EXPECT_EQ(info->text, text);
}

TEST(Png, IsNoneWithoutItsEnd) {
  const test::TempFolder folder;
  ASSERT_TRUE(writePng(folder / "chart.png", chart()));
  const std::string whole = test::bytesOf(folder / "chart.png");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::ofstream(folder / "part.png", std::ios::binary) << whole.substr(0, length);
    ASSERT_FALSE(readPngInfo(folder / "part.png")) << length;
  }
  std::ofstream(folder / "part.png", std::ios::binary) << whole;
  EXPECT_TRUE(readPngInfo(folder / "part.png"));
  EXPECT_FALSE(readPngInfo(folder / "none.png"));
}

TEST(Png, IsTheSameBytesTwice) {
  const test::TempFolder folder;
  ASSERT_TRUE(writePng(folder / "a.png", chart()));
  ASSERT_TRUE(writePng(folder / "b.png", chart()));
  EXPECT_EQ(test::bytesOf(folder / "a.png"), test::bytesOf(folder / "b.png"));
}

TEST(Png, ReplacesAnOlderPicture) {
  const test::TempFolder folder;
  std::ofstream(folder / "a.png") << "old";
  ASSERT_TRUE(writePng(folder / "a.png", chart()));
  EXPECT_TRUE(readPng(folder / "a.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png.part"));
}

}  // namespace
}  // namespace bedmix
