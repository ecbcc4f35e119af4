// SPDX-License-Identifier: MIT
#include "render/plot.h"

#include "render/png.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace bedmix {
namespace {

std::vector<Curve> curves(bool gap) {
  Curve lacey{"Lacey", {}, {}}, ashton{"Ashton's", {}, {}};
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    lacey.x.push_back(t);
    ashton.x.push_back(t);
    lacey.y.push_back(1.0 - std::exp(-t));
    ashton.y.push_back(gap && i > 40 && i < 60 ? std::nan("") : 1.0 - std::exp(-0.5 * t));
  }
  return {lacey, ashton};
}

Image plotted(const test::TempFolder& folder, const char* kind, const std::vector<Curve>& data) {
  const Result<Done> done = writePlot(folder / "plot.png", **findPlotKind(kind), data);
  EXPECT_TRUE(done) << done.problems[0].message;
  const Result<Image> image = readPng(folder / "plot.png");
  EXPECT_TRUE(image);
  return *image;
}

/// Columns of the picture in which the curve's colour appears, legend above left out.
std::set<int> columnsOf(const Image& image, Rgba color) {
  std::set<int> columns;
  for (int y = image.size.height / 10; y < image.size.height; ++y)
    for (int x = 0; x < image.size.width; ++x)
      if (image.at(x, y) == color) columns.insert(x);
  return columns;
}

TEST(Plot, IsAPictureOfTheRightSize) {
  const test::TempFolder folder;
  for (const PlotKind& kind : plotKinds())
    EXPECT_EQ(plotted(folder, std::string(kind.name).c_str(), curves(false)).size, (Size{1500, 900}))
        << kind.name;
}

TEST(Plot, LeavesGapsOpen) {
  const test::TempFolder folder;
  const Rgba green{0, 158, 115};
  const std::set<int> whole = columnsOf(plotted(folder, "mixing", curves(false)), green);
  const std::set<int> gap = columnsOf(plotted(folder, "mixing", curves(true)), green);
  ASSERT_GT(whole.size(), 1000u);
  // 2.0 of the 10 s are missing.
  EXPECT_NEAR(static_cast<double>(gap.size()) / static_cast<double>(whole.size()), 0.8, 0.03);
}

TEST(Plot, ShowsIndicesBelowZeroAndAboveItsUsualRange) {
  const test::TempFolder folder;
  for (const double value : {-0.5, 0.5, 1.7}) {
    const std::vector<Curve> flat{{"usual", {0.0, 10.0}, {0.2, 0.2}}, {"other", {0.0, 10.0}, {value, value}}};
    EXPECT_GT(columnsOf(plotted(folder, "mixing", flat), {0, 158, 115}).size(), 1000u) << value;
  }
}

TEST(Plot, IsTheSameBytesTwice) {
  const test::TempFolder folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    ASSERT_TRUE(writePlot(folder / name, plotKinds().front(), curves(true)));
    const std::string first = test::bytesOf(folder / name);
    ASSERT_TRUE(writePlot(folder / name, plotKinds().front(), curves(true)));
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(first, test::bytesOf(folder / name)) << name;
  }
}

TEST(Plot, PdfHoldsNoDay) {
  const test::TempFolder folder;
  ASSERT_TRUE(writePlot(folder / "a.pdf", plotKinds().front(), curves(false)));
  const std::string bytes = test::bytesOf(folder / "a.pdf");
  EXPECT_EQ(bytes.rfind("%PDF", 0), 0u);
  const std::size_t date = bytes.find("CreationDate (D:");
  EXPECT_TRUE(date == std::string::npos || bytes.compare(date + 16, 8, "20000101") == 0);
}

TEST(Plot, KindsAreFoundByName) {
  const Result<const PlotKind*> mixing = findPlotKind("mixing");
  ASSERT_TRUE(mixing);
  EXPECT_EQ((*mixing)->file, "mixing.csv");
  ASSERT_EQ((*mixing)->columns.size(), 2u);
  EXPECT_EQ((*mixing)->columns[1].name, "ashton");
  const Result<const PlotKind*> none = findPlotKind("histogram");
  ASSERT_FALSE(none);
  EXPECT_NE(none.problems[0].message.find("mixing, compare, flux, pressure"), std::string::npos);
}

TEST(Plot, NamesOfFilesAreTakenAsTheyAre) {
  const test::TempFolder folder;
  EXPECT_TRUE(writePlot(folder / "it's a \"plot\" $x.png", plotKinds().front(), curves(false)));
  EXPECT_TRUE(readPng(folder / "it's a \"plot\" $x.png"));
}

}  // namespace
}  // namespace bedmix
