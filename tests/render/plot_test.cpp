// SPDX-License-Identifier: MIT
#include "render/plot.h"

#include "render/band.h"
#include "render/png.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace bedmix {
namespace {

std::vector<Curve> curves(bool gap) {
  Curve lacey{"Lacey", {}, {}, {}, {}}, ashton{"Ashton's", {}, {}, {}, {}};
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

TEST(Plot, IsAColumnOfAJournalWideAndSaysSo) {
  const test::TempFolder folder;
  for (const PlotKind& kind : plotKinds())
    EXPECT_EQ(plotted(folder, std::string(kind.name).c_str(), curves(false)).size, (Size{2079, 1299}))
        << kind.name;
  // 88 mm at 600 dpi, which are 23622 dots a metre.
  const std::string bytes = test::bytesOf(folder / "plot.png");
  const std::size_t at = bytes.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.substr(at + 4, 9), std::string("\0\0\x5C\x46\0\0\x5C\x46\1", 9));
}

TEST(Plot, GrowsForALongLegendInsteadOfPressingTheCurves) {
  const test::TempFolder folder;
  std::vector<Curve> data = curves(false);
  data[0].label = "a label that fills a good part of the width of a column";
  EXPECT_GT(plotted(folder, "mixing", data).size.height, 1299 + 200);
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
    const std::vector<Curve> flat{{"usual", {0.0, 10.0}, {0.2, 0.2}, {}, {}},
                                  {"other", {0.0, 10.0}, {value, value}, {}, {}}};
    EXPECT_GT(columnsOf(plotted(folder, "mixing", flat), {0, 158, 115}).size(), 1000u) << value;
  }
}

TEST(Plot, LeavesWhatItDrawsBesideTheFigure) {
  const test::TempFolder folder;
  const double gap = std::nan("");
  const std::vector<Curve> data{{"all, the way", {0.0, 0.5, 1.0}, {0.25, gap, 0.75}, {}, {}},
                                {"ensemble", {0.0, 1.0}, {0.5, 0.5}, {0.125, 0.25}, {1.0, 2.0}}};
  ASSERT_TRUE(writePlot(folder / "m.png", plotKinds().front(), data));
  EXPECT_EQ(test::bytesOf(folder / "m.png.csv"),
            "time,\"all, the way\",ensemble,ensemble low,ensemble high\n"
            "0,0.25,0.5,0.125,1\n"
            "0.5,nan,,,\n"
            "1,0.75,0.5,0.25,2\n");
}

TEST(Plot, IsDrawnAnewByTheScriptBesideIt) {
  for (const char* ending : {".png", ".svg", ".pdf"}) {
    const test::TempFolder folder, other;
    const std::string name = std::string("it's") + ending;
    ASSERT_TRUE(writePlot(folder / name.c_str(), plotKinds().front(), curves(true), {{{0.9, "A = 0.9"}}}));
    for (const char* part : {".csv", ".gp"})
      std::filesystem::copy(folder / (name + part).c_str(), other / (name + part).c_str());
    const std::string command = "cd '" + (other / "").string() + "' && gnuplot \"" + name + ".gp\" 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto drawn = other / name.c_str();
    if (std::string(ending) == ".png")
      EXPECT_EQ(readPng(drawn)->rgba, readPng(folder / name.c_str())->rgba);
    else
      EXPECT_EQ(std::filesystem::file_size(drawn), std::filesystem::file_size(folder / name.c_str()));
  }
}

TEST(Plot, LeavesNothingWhereItFails) {
  const test::TempFolder folder;
  EXPECT_FALSE(writePlot(folder / "a.bmp", plotKinds().front(), curves(false)));
  std::filesystem::create_directory(folder / "taken.png");
  EXPECT_FALSE(writePlot(folder / "taken.png", plotKinds().front(), curves(false)));
  EXPECT_FALSE(writePlot(folder / "no/such/folder.png", plotKinds().front(), curves(false)));
  std::filesystem::remove(folder / "taken.png");
  for (const auto& left : std::filesystem::directory_iterator(folder / ""))
    EXPECT_NE(left.path().extension(), ".part") << left.path();
}

TEST(Plot, BandIsDrawnUnderItsMedian) {
  const test::TempFolder folder;
  const std::vector<Curve> band{{"band", {0.0, 10.0}, {0.5, 0.5}, {0.25, 0.25}, {1.0, 1.0}}};
  const Image image = plotted(folder, "mixing", band);
  int dark = 0, shaded = 0;
  const int x = image.size.width / 2;
  for (int y = 0; y < image.size.height; ++y) {
    const Rgba c = image.at(x, y);
    dark += c.r < 10 && c.g < 10 && c.b < 10;
    shaded += c.r > 180 && c.r < 200 && c.r == c.g && c.g == c.b;  // a quarter of black
  }
  EXPECT_GT(dark, 0);
  EXPECT_GT(shaded, image.size.height / 4);
}

TEST(Band, IsMedianAndQuantilesAtEachTime) {
  std::vector<Curve> runs;
  for (int i = 0; i <= 10; ++i) runs.push_back({"", {0.0, 1.0}, {1.0 * i, 10.0 * i}, {}, {}});
  std::swap(runs[2], runs[9]);
  const Curve band = medianAndBand(runs, "eleven");
  EXPECT_EQ(band.label, "eleven");
  EXPECT_EQ(band.x, (std::vector{0.0, 1.0}));
  EXPECT_EQ(band.y, (std::vector{5.0, 50.0}));
  EXPECT_EQ(band.low, (std::vector{1.0, 10.0}));
  EXPECT_EQ(band.high, (std::vector{9.0, 90.0}));
}

TEST(Band, OfTwoLiesBetweenThem) {
  const std::vector<Curve> two{{"", {0.0}, {1.0}, {}, {}}, {"", {0.0}, {2.0}, {}, {}}};
  const Curve band = medianAndBand(two, "");
  EXPECT_DOUBLE_EQ(band.low[0], 1.1);
  EXPECT_DOUBLE_EQ(band.y[0], 1.5);
  EXPECT_DOUBLE_EQ(band.high[0], 1.9);
}

TEST(Band, TakesCommonTimesAndPassesOverGaps) {
  const double gap = std::nan("");
  const std::vector<Curve> runs{{"", {0.0, 0.5, 1.0, 1.5}, {1.0, 2.0, 3.0, gap}, {}, {}},
                                {"", {0.0, 1.0}, {3.0, gap}, {}, {}}};
  const Curve band = medianAndBand(runs, "");
  EXPECT_EQ(band.x,
            (std::vector{0.0, 1.0, 1.5}));  // at 0.5 s the second has no sample, at 1.5 s it has ended
  EXPECT_EQ(band.y[0], 2.0);
  EXPECT_EQ(band.y[1], 3.0);
  EXPECT_TRUE(std::isnan(band.y[2]) && std::isnan(band.low[2]) && std::isnan(band.high[2]));
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
