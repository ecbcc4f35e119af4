// SPDX-License-Identifier: MIT
#include "render/av_film.h"
#include "render/film_kind.h"
#include "render/film_sink.h"
#include "render/gnuplot.h"
#include "render/mp4_film.h"
#include "render/plot.h"
#include "render/png.h"
#include "render/sheet.h"
#include "render/surface.h"
#include "tests/render/bed.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace bedmix {
namespace {

Image blank(Size size) {
  Image image;
  image.resize(size);
  return image;
}

template <class T>
void expectFileTrouble(const Result<T>& result) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.problems[0].trouble, Trouble::file);
  EXPECT_FALSE(result.problems[0].at.file.empty());
  EXPECT_FALSE(result.problems[0].message.empty());
}

/// Makes the file that `target` is written to a device that is always full.
void fillDisk(const std::filesystem::path& target) {
  std::filesystem::create_symlink("/dev/full", target.native() + ".part");
}

const std::vector<Curve> line{{"line", {0.0, 1.0}, {0.0, 1.0}}};

TEST(RenderFaults, SizesBeyondTheLimits) {
  for (const Size size : {Size{16385, 100}, Size{100, 16385}, Size{15, 100}, Size{0, 100}, Size{-5, 5}}) {
    const Result<Painter> painter = Painter::create(test::flatBed(), {size, defaultLayers, 0});
    ASSERT_FALSE(painter);
    EXPECT_EQ(painter.problems[0].trouble, Trouble::input);
    EXPECT_NE(painter.problems[0].message.find("16384"), std::string::npos);
  }
}

TEST(RenderFaults, LayersTheSceneOrTheFrameCannotShow) {
  EXPECT_FALSE(Painter::create(test::gaslessBed(), {{64, 64}, {Layer::pressure}, 0}));
  Result<Painter> painter = Painter::create(test::flatBed(), {{64, 64}, {Layer::pressure}, 0});
  ASSERT_TRUE(painter);
  Image image;
  const Result<Done> done = painter->paint(test::particlesAt({{0.01f, 0.01f}}, {}), image);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.problems[0].trouble, Trouble::file);
}

TEST(RenderFaults, FolderThatCannotBeWritten) {
  const test::TempFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  expectFileTrouble(writePng(folder / "file/a.png", blank({16, 16})));
  expectFileTrouble(writePng(folder / "none/a.png", blank({16, 16})));
  expectFileTrouble(FilmSink::create(test::flatBed(), folder / "none/a.mp4"));
  expectFileTrouble(writePlot(folder / "none/a.png", plotKinds().front(), line));
}

TEST(RenderFaults, FullDiskUnderAPicture) {
  const test::TempFolder folder;
  fillDisk(folder / "a.png");
  const Result<Done> done = writePng(folder / "a.png", blank({400, 400}));
  expectFileTrouble(done);
  EXPECT_NE(done.problems[0].message.find("No space left"), std::string::npos) << done.problems[0].message;
  EXPECT_TRUE(folder.empty());
}

TEST(RenderFaults, FullDiskKeepsAnOlderPicture) {
  const test::TempFolder folder;
  ASSERT_TRUE(writePng(folder / "a.png", blank({16, 16})));
  fillDisk(folder / "a.png");
  EXPECT_FALSE(writePng(folder / "a.png", blank({400, 400})));
  EXPECT_EQ(readPng(folder / "a.png")->size, (Size{16, 16}));
}

class RenderFaultsFilm : public ::testing::TestWithParam<std::string> {};

TEST_P(RenderFaultsFilm, FullDisk) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder / GetParam().c_str();
  fillDisk(file);
  Result<FilmSink> sink = FilmSink::create(test::flatBed(), file, {{{240, 420}, defaultLayers, 0}});
  Result<Done> done = Done{};
  if (sink) {
    Frame frame = test::movingFrame(test::flatBed());
    for (int i = 0; i < 200; ++i) {
      frame.time = 0.02 * i;
      sink->accept(frame);
    }
    done = sink->finish();
  } else {
    done = sink.problems;
  }
  expectFileTrouble(done);
  EXPECT_NE(done.problems[0].message.find("No space left"), std::string::npos) << done.problems[0].message;
  sink = Diagnostic{};
  EXPECT_TRUE(folder.empty());
}

TEST_P(RenderFaultsFilm, OneThatIsLeftUnfinished) {
  const test::TempFolder folder;
  {
    Result<FilmSink> sink =
        FilmSink::create(test::flatBed(), folder / GetParam().c_str(), {{{240, 420}, defaultLayers, 0}});
    ASSERT_TRUE(sink);
    Frame frame = test::movingFrame(test::flatBed());
    for (int i = 0; i < 20; ++i) {
      frame.time = 0.02 * i;
      sink->accept(frame);
    }
  }
  EXPECT_TRUE(folder.empty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, RenderFaultsFilm, ::testing::Values("a.mp4", "a.gif", "a.mkv"));

TEST(RenderFaults, FilmsTooLargeForTheirKind) {
  const test::TempFolder folder;
  for (const char* name : {"a.mp4", "a.mkv"}) {
    const auto film = createFilm(folder / name, {16384, 16384}, 50.0);
    ASSERT_FALSE(film);
    EXPECT_EQ(film.problems[0].trouble, Trouble::input);
    EXPECT_NE(film.problems[0].message.find("16384x16384 is too large"), std::string::npos);
  }
  EXPECT_TRUE(createFilm(folder / "a.mkv", {8192, 8192}, 50.0));
  EXPECT_TRUE(folder.empty());
}

TEST(RenderFaults, WithoutAnEncoder) {
  const test::TempFolder folder;
  AvFilm film(folder / "a.mp4", {"libnone", "mp4", ""});
  const Result<Done> done = film.findEncoder({64, 64}, {50, 1});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.problems[0].trouble, Trouble::unavailable);
  EXPECT_NE(done.problems[0].message.find("libavcodec has no libnone"), std::string::npos);
  EXPECT_TRUE(folder.empty());
}

TEST(RenderFaults, FullDiskWhenTheFilmIsFinished) {
  const test::TempFolder folder;
  Result<Mp4Film> movie = Mp4Film::create(folder / "a.mp4", {64, 64}, 50.0);
  ASSERT_TRUE(movie);
  for (int i = 0; i < 60; ++i) ASSERT_TRUE(movie->add(blank({64, 64})));
  std::filesystem::create_symlink("/dev/full", folder / "a.mp4.whole.part");
  expectFileTrouble(movie->finish());
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mp4"));
}

TEST(RenderFaults, FullDiskUnderAPlot) {
  const test::TempFolder folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    fillDisk(folder / name);
    expectFileTrouble(writePlot(folder / name, plotKinds().front(), line));
    EXPECT_TRUE(folder.empty());
  }
}

TEST(RenderFaults, PlotsThatCannotBe) {
  const test::TempFolder folder;
  EXPECT_FALSE(writePlot(folder / "a.jpg", plotKinds().front(), line));
  EXPECT_FALSE(writePlot(folder / "a.png", plotKinds().front(), {}));
  EXPECT_FALSE(
      writePlot(folder / "a.png", plotKinds().front(), std::vector<Curve>{{"none", {0.0}, {std::nan("")}}}));
  EXPECT_TRUE(folder.empty());
}

TEST(RenderFaults, WithoutGnuplot) {
  const test::TempFolder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder / "none").c_str(), 1);
  const Result<Done> done = writePlot(folder / "a.png", plotKinds().front(), line);
  const Result<std::string> probe = probePlotter();
  setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.problems[0].trouble, Trouble::unavailable);
  EXPECT_NE(done.problems[0].message.find("gnuplot-nox"), std::string::npos);
  EXPECT_FALSE(probe);
  EXPECT_TRUE(folder.empty());
}

TEST(RenderFaults, FilesThatAreNoPng) {
  const test::TempFolder folder;
  std::ofstream(folder / "a.png") << "text";
  expectFileTrouble(readPng(folder / "a.png"));
  expectFileTrouble(readPng(folder / "none.png"));
}

TEST(RenderFaults, ProbesSayWhatIsHere) {
  EXPECT_NE(probeSurface()->find("OpenGL"), std::string::npos);
  EXPECT_NE(probeEncoder()->find("libx264"), std::string::npos);
  EXPECT_NE(probePlotter()->find("gnuplot"), std::string::npos);
}

}  // namespace
}  // namespace bedmix
