// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_series.h"

#include "tests/replay/synthetic.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

namespace bedmix::test {
namespace {

/// Two points in the XML form, with the arrays of `pointData`.
std::string vtp(const std::string& pointData, const std::string& coordinates = "0.125 2 3 -4 5e-1 6") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"2\">\n<Points>\n<DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"ascii\">" +
         coordinates + "</DataArray>\n</Points>\n<PointData>" + pointData +
         "</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}
std::string array(const std::string& name, int components, const std::string& values) {
  return fmt::format(
      "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">{}</DataArray>",
      name, components, values);
}
const std::string legacy =
    "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0.125 2 3\n-4 0.5 "
    "6\nVERTICES 2 4\n"
    "1 0\n1 1\nPOINT_DATA 2\nSCALARS id int\nLOOKUP_TABLE default\n7 3\nVECTORS v double\n1 2 3\n4 5 6\n"
    "FIELD FieldData 2\nDiameter 1 2 float\n0.5 0.25\nignored 2 2 int\n1 2 3 4\n";

class VtkSeries : public testing::Test {
 protected:
  std::string problemOf(const std::string& name, const std::string& text) {
    writeText(folder_ / name, text);
    const auto series = openVtkSeries(std::vector{folder_ / name});
    if (series) return "";
    EXPECT_EQ(series.problems.front().trouble, Trouble::file);
    const std::string message = toString(series.problems.front());
    return message.substr(message.find(name));
  }
  ForeignFrame frameOf(const std::string& name, const std::string& text) {
    writeText(folder_ / name, text);
    auto series = openVtkSeries(std::vector{folder_ / name});
    EXPECT_TRUE(series) << toString(series.problems.front());
    return series ? *(*series)->frame(0) : ForeignFrame{};
  }
  TemporaryFolder folder_;
};

TEST_F(VtkSeries, WhatVtkItselfHasWritten) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BEDMIX_SAMPLES "/vtk")) {
    SCOPED_TRACE(entry.path());
    ++files;
    auto series = openVtkSeries(std::vector{entry.path()});
    ASSERT_TRUE(series) << toString(series.problems.front());
    const auto frame = (*series)->frame(0);
    ASSERT_TRUE(frame);
    constexpr int n = 40;
    ASSERT_EQ(frame->position.size(), std::size_t{n});
    ASSERT_EQ(frame->velocity.size(), std::size_t{n});
    ASSERT_EQ(frame->radius.size(), std::size_t{n});
    ASSERT_EQ(frame->id.size(), std::size_t{n});
    ASSERT_EQ(frame->species.size(), std::size_t{n});
    EXPECT_TRUE(frame->angularVelocity.empty());
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_EQ(frame->position[at], (Vec3d{i / 8.0, -i / 4.0, 1.0 * i * i}));
      EXPECT_EQ(frame->velocity[at], (Vec3d{i / 2.0, 1.0 - i, 0.125}));
      EXPECT_EQ(frame->radius[at], 1.0 / (1 << i % 5));
      EXPECT_EQ(frame->id[at], 2 * n - i);
      EXPECT_EQ(frame->species[at], i % 3);
    }
  }
  EXPECT_EQ(files, 22);
}

TEST_F(VtkSeries, NamesOfArraysAreThoseInUse) {
  const ForeignFrame a = frameOf(
      "a.vtp", vtp(array("Velocity", 3, "1 2 3 4 5 6") + array("ID", 1, "9 8") + array("Type", 1, "1 2") +
                   array("diameter", 1, "1 3") + array("angular_velocity", 3, "6 5 4 3 2 1")));
  EXPECT_EQ(a.position, (std::vector<Vec3d>{{0.125, 2.0, 3.0}, {-4.0, 0.5, 6.0}}));
  EXPECT_EQ(a.velocity, (std::vector<Vec3d>{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
  EXPECT_EQ(a.id, (std::vector<std::int64_t>{9, 8}));
  EXPECT_EQ(a.species, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(a.radius, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(a.angularVelocity, (std::vector<Vec3d>{{6.0, 5.0, 4.0}, {3.0, 2.0, 1.0}}));

  const ForeignFrame b = frameOf("b.vtk", legacy);
  EXPECT_EQ(b.position, a.position);
  EXPECT_EQ(b.velocity, a.velocity);
  EXPECT_EQ(b.id, (std::vector<std::int64_t>{7, 3}));
  EXPECT_EQ(b.radius, (std::vector<double>{0.25, 0.125}));
  EXPECT_TRUE(b.species.empty());
}

TEST_F(VtkSeries, ACollectionHasTimes) {
  std::filesystem::create_directory(folder_ / "data");
  writeText(folder_ / "data/b.vtp", vtp(""));
  writeText(folder_ / "a.vtp", vtp("", "1 1 1 2 2 2"));
  const auto pvd = [](const std::string& second) {
    return "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0.5\" file=\"a.vtp\"/>\n" + second +
           "</Collection></VTKFile>";
  };
  writeText(folder_ / "run.pvd", pvd("<DataSet timestep=\"1.25\" part=\"0\" file=\"data/b.vtp\"/>"));
  auto series = openVtkSeries(std::vector{folder_ / "run.pvd"});
  ASSERT_TRUE(series) << toString(series.problems.front());
  EXPECT_EQ((*series)->times(), (std::vector<double>{0.5, 1.25}));
  EXPECT_EQ((*series)->steps(), (std::vector<std::int64_t>{0, 1}));
  EXPECT_EQ((*series)->frame(1)->position.at(1), (Vec3d{-4.0, 0.5, 6.0}));
  EXPECT_EQ((*series)->frame(0)->position.at(1), (Vec3d{2.0, 2.0, 2.0}));

  for (const std::string outside : {"../a.vtp", "data/../../a.vtp", "/a.vtp", ""})
    EXPECT_NE(problemOf("run.pvd", pvd("<DataSet timestep=\"2\" file=\"" + outside + "\"/>"))
                  .find("run.pvd:2:1: names '"),
              std::string::npos);
  EXPECT_NE(
      problemOf("run.pvd", pvd("<DataSet timestep=\"0.5\" file=\"b.vtp\"/>")).find("times must increase"),
      std::string::npos);
}

TEST_F(VtkSeries, AFolderIsTakenByItsNumbers) {
  for (const int step : {1000, 20, 300}) writeText(folder_ / fmt::format("dump{}.vtk", step), legacy);
  writeText(folder_ / "dump20_boundingBox.vtk", "no particles");
  writeText(folder_ / "notes.txt", "");
  const auto series = openVtkSeries(std::vector{folder_.path()});
  ASSERT_TRUE(series) << toString(series.problems.front());
  EXPECT_EQ((*series)->steps(), (std::vector<std::int64_t>{20, 300, 1000}));
  EXPECT_TRUE((*series)->times().empty());
  writeText(folder_ / "walls20.vtp", vtp(""));
  EXPECT_FALSE(openVtkSeries(std::vector{folder_.path()}));
}

TEST_F(VtkSeries, CutOffAnywhereNoNumberIsWrong) {
  for (const char* name : {"ascii.vtp", "appended.vtp", "appended-zlib.vtp", "appended-big.vtp",
                           "binary-zlib.vtu", "binary-poly.vtk", "ascii-grid.vtk"}) {
    const std::string text = fileText(std::filesystem::path(BEDMIX_SAMPLES "/vtk") / name);
    const ForeignFrame whole = frameOf(name, text);
    for (std::size_t size = 0; size < text.size(); size += 1 + size / 30) {
      writeText(folder_ / name, text.substr(0, size));
      auto series = openVtkSeries(std::vector{folder_ / name});
      if (!series) continue;
      const auto frame = (*series)->frame(0);
      ASSERT_EQ(frame->position, whole.position) << name << ' ' << size;
      for (const auto& [part, all] : {std::pair{&frame->velocity, &whole.velocity}})
        ASSERT_TRUE(part->empty() || *part == *all);
      ASSERT_TRUE(frame->id.empty() || frame->id == whole.id);
    }
  }
}

TEST_F(VtkSeries, SaysWhatIsWrong) {
  EXPECT_EQ(problemOf("a.vtp", vtp("", "1 2 3 4 5 x")), "a.vtp:6:11: 'x' is not a number");
  EXPECT_EQ(problemOf("a.vtp", vtp("", "1 2 3 4 5 nan")), "a.vtp:6:11: 'nan' is not a number");
  EXPECT_NE(problemOf("a.vtp", vtp("", "1 2 3")).find("2 points and holds 3"), std::string::npos);
  EXPECT_NE(problemOf("a.vtp", vtp(array("id", 1, "1"))).find("id has 1 numbers for 2 points"),
            std::string::npos);
  EXPECT_NE(problemOf("a.vtp", vtp(array("id", 1, "1 1"))).find("stands more than once"), std::string::npos);
  EXPECT_NE(problemOf("a.vtp", vtp(array("id", 1, "1 2.5"))).find("2.5 is no id"), std::string::npos);
  EXPECT_NE(problemOf("a.vtp", "<a/>").find("no VTKFile"), std::string::npos);
  EXPECT_NE(problemOf("a.vtp", "<VTKFile type=\"ImageData\"/>").find("ImageData"), std::string::npos);
  EXPECT_NE(problemOf("a.vtp", "").find("a.vtp"), std::string::npos);
  EXPECT_NE(problemOf("a.vtk", "no").find("no legacy file"), std::string::npos);
  EXPECT_NE(
      problemOf("a.vtk",
                "# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 9999999999999 float\nab")
          .find("cut off"),
      std::string::npos);
  EXPECT_NE(problemOf("a.txt", "").find("is no .pvd"), std::string::npos);
  EXPECT_FALSE(openVtkSeries({}));
  EXPECT_FALSE(openVtkSeries(std::vector{folder_ / "none.vtp"}));
}

}  // namespace
}  // namespace bedmix::test
