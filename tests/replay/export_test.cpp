// SPDX-License-Identifier: MIT
#include "engine/core/gas_grid.h"
#include "replay/csv.h"
#include "replay/export/export_format.h"
#include "tests/replay/synthetic.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace bedmix::test {
namespace {

const std::vector<std::size_t> selected{0, 2, 4};

class ExportFormats : public testing::Test {
 protected:
  ExportFormats() { scene_.floor.inclinationDeg = 18.0; }

  /// Exports the selected frames of a run of five.
  std::vector<std::filesystem::path> write(const std::string& format) const {
    const auto found = findExportFormat(format);
    EXPECT_TRUE(found);
    const auto made = (*found)->open({scene_, folder_ / "trajectory.h5", 5, selected, folder_.path()});
    EXPECT_TRUE(made) << toString(made.problems.front());
    for (const std::size_t i : selected) (*made)->accept(syntheticFrame(scene_, static_cast<int>(i)));
    EXPECT_FALSE((*made)->failure());
    for (const auto& file : (*made)->files()) EXPECT_TRUE(std::filesystem::exists(file)) << file;
    return (*made)->files();
  }
  /// Whether another program gets the same numbers from it. Skips where Python lacks `module`.
  void expectSameIn(const std::string& kind, const std::string& module) const {
    const std::string python = "/usr/bin/python3";
    if (std::system((python + " -c 'import h5py, " + module + "' 2>/dev/null").c_str()) != 0)
      GTEST_SKIP() << python << " has no h5py or no " << module;
    record(folder_ / "trajectory.h5", scene_, 5);
    if (kind != "h5md") write(kind);
    const std::string command =
        fmt::format("{} {}/tests/replay/export_check.py {} {} {} {} 2>&1", python, BEDMIX_SOURCE_DIR, kind,
                    folder_.path().string(), (folder_ / "trajectory.h5").string(), fmt::join(selected, " "));
    std::string said;
    FILE* const pipe = popen(command.c_str(), "r");
    for (char line[256]; fgets(line, sizeof line, pipe);) said += line;
    EXPECT_EQ(pclose(pipe), 0) << said;
  }

  Scene scene_ = syntheticScene(true, true);
  TemporaryFolder folder_;
};

TEST_F(ExportFormats, H5pyReadsTheTrajectoryByTheRulesOfH5md) { expectSameIn("h5md", "numpy"); }
TEST_F(ExportFormats, VtkReadsTheSameNumbers) { expectSameIn("vtk", "vtkmodules.vtkIOXML"); }
TEST_F(ExportFormats, ParaViewReadsTheSameNumbersThroughXdmf) {
  expectSameIn("xdmf", "vtkmodules.vtkIOXdmf2");
}
TEST_F(ExportFormats, AseReadsTheSameNumbersFromExtendedXyz) { expectSameIn("extxyz", "ase.io"); }
TEST_F(ExportFormats, AseReadsTheSamePositionsFromADump) { expectSameIn("lammps", "ase.io"); }

TEST_F(ExportFormats, TablesReadBackToTheSameBits) {
  write("csv");
  const auto particles = readCsv(folder_ / "particles.csv"), gas = readCsv(folder_ / "gas.csv");
  ASSERT_TRUE(particles && gas);
  EXPECT_EQ(particles->names,
            (std::vector<std::string>{"time", "id", "species", "x", "y", "vx", "vy", "omega"}));
  const auto bits = [](const Table& table, std::size_t row, std::vector<double> expected) {
    for (std::size_t c = 0; c < expected.size(); ++c) {
      EXPECT_EQ(table.columns[c][row], expected[c]) << row << ", " << table.names[c];
      EXPECT_EQ(std::signbit(*table.columns[c][row]), std::signbit(expected[c]));
    }
  };
  const GasGrid grid = makeGasGrid(scene_);
  std::size_t row = 0, gasRow = 0;
  for (const std::size_t index : selected) {
    const Frame f = syntheticFrame(scene_, static_cast<int>(index));
    for (std::size_t i = 0; i < f.size(); ++i, ++row) {
      const auto number = [&](std::size_t c) { return static_cast<float>(*particles->columns[c][row]); };
      bits(*particles, row, {f.time, static_cast<double>(f.id[i]), static_cast<double>(f.species[i])});
      const float expected[]{f.position[i].x, f.position[i].y, f.velocity[i].x, f.velocity[i].y,
                             f.angularVelocity[i]};
      for (std::size_t c = 0; c < 5; ++c) {
        EXPECT_EQ(number(3 + c), expected[c]) << row;
        EXPECT_EQ(std::signbit(number(3 + c)), std::signbit(expected[c])) << row;
      }
    }
    for (int r = 0; r < grid.rows; ++r)
      for (int c = grid.columns - 1; c >= 0; --c) gasRow += grid.open(c, r);
  }
  EXPECT_EQ(particles->rows(), row);
  EXPECT_EQ(gas->rows(), gasRow);
  EXPECT_LT(gasRow, selected.size() * grid.cells());  // the distributor's steps are left out
  // The first open cell: the bottom row's leftmost.
  const Frame first = syntheticFrame(scene_, 0);
  bits(*gas, 0, {0.0, 0.006, 0.006});
  EXPECT_EQ(static_cast<float>(*gas->columns[3][0]), first.gas.voidage[0]);
  EXPECT_EQ(static_cast<float>(*gas->columns[6][0]), first.gas.velocity[0].y);
}

TEST_F(ExportFormats, TablesHoldTemperatures) {
  addHeat(scene_);
  write("csv");
  const auto particles = readCsv(folder_ / "particles.csv"), gas = readCsv(folder_ / "gas.csv");
  ASSERT_TRUE(particles && gas);
  EXPECT_EQ(particles->names.back(), "temperature");
  EXPECT_EQ(gas->names.back(), "gas_temperature");
  const Frame first = syntheticFrame(scene_, 0);
  EXPECT_EQ(static_cast<float>(*particles->columns.back()[0]), first.temperature[0]);
  EXPECT_EQ(static_cast<float>(*gas->columns.back()[0]), first.gas.temperature[0]);
}

TEST_F(ExportFormats, HoldThoseWhoAreThereOfParticlesThatComeAndGo) {
  addFeed(scene_);
  write("csv");
  const auto particles = readCsv(folder_ / "particles.csv");
  ASSERT_TRUE(particles);
  std::size_t row = 0;
  for (const std::size_t index : selected)
    for (const std::int32_t id : syntheticFrame(scene_, static_cast<int>(index)).id)
      EXPECT_EQ(particles->columns[1][row++], static_cast<double>(id));
  EXPECT_EQ(particles->rows(), row);
  EXPECT_GT(row, 0u);
  const auto xdmf =
      (*findExportFormat("xdmf"))->open({scene_, folder_ / "trajectory.h5", 5, selected, folder_.path()});
  ASSERT_FALSE(xdmf);
  EXPECT_NE(xdmf.problems.front().message.find("take vtk"), std::string::npos);
}

TEST_F(ExportFormats, ADumpHoldsTheFramesOfItsTimes) {
  write("lammps");
  std::istringstream text(fileText(folder_ / "particles.lammpstrj"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "ITEM: UNITS");
  std::getline(text, line);
  EXPECT_EQ(line, "si");
  for (const std::size_t index : selected) {
    const Frame f = syntheticFrame(scene_, static_cast<int>(index));
    const auto next = [&] { return std::getline(text, line), line; };
    EXPECT_EQ(next(), "ITEM: TIME");
    EXPECT_EQ(std::stod(next()), f.time);
    EXPECT_EQ(next(), "ITEM: TIMESTEP");
    EXPECT_EQ(next(), std::to_string(f.step));
    EXPECT_EQ(next(), "ITEM: NUMBER OF ATOMS");
    EXPECT_EQ(next(), "60");
    EXPECT_EQ(next(), "ITEM: BOX BOUNDS ff ff ff");
    EXPECT_EQ(next(), "0 0.048");
    EXPECT_EQ(next(), "0 0.12");
    EXPECT_EQ(next(), "-0.002 0.002");
    EXPECT_EQ(next(), "ITEM: ATOMS id type x y z vx vy vz radius omegaz");
    for (std::size_t i = 0; i < f.size(); ++i)
      EXPECT_EQ(next(), fmt::format("{} {} {} {} 0 {} {} 0 0.002 {}", f.id[i], f.species[i] == 1 ? 2 : 1,
                                    f.position[i].x, f.position[i].y, f.velocity[i].x, f.velocity[i].y,
                                    f.angularVelocity[i]));
  }
  EXPECT_FALSE(std::getline(text, line));
}

TEST_F(ExportFormats, AbsentEffectsLeaveNoTrace) {
  scene_ = syntheticScene(false, false);
  for (const ExportFormat& format : exportFormats()) write(std::string(format.name));
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_FALSE(entry.path().filename().string().starts_with("gas")) << entry.path();
    EXPECT_EQ(fileText(entry.path()).find("omega"), std::string::npos) << entry.path();
    EXPECT_EQ(fileText(entry.path()).find("angular"), std::string::npos) << entry.path();
    EXPECT_EQ(fileText(entry.path()).find("temperature"), std::string::npos) << entry.path();
  }
}

TEST_F(ExportFormats, NothingIsOverwritten) {
  for (const ExportFormat& format : exportFormats()) {
    const auto files = write(std::string(format.name));
    const std::string before = fileText(files.front());
    const auto again = format.open({scene_, folder_ / "trajectory.h5", 5, selected, folder_.path()});
    ASSERT_FALSE(again);
    EXPECT_EQ(again.problems.front().trouble, Trouble::file);
    EXPECT_NE(toString(again.problems.front()).find("is there already"), std::string::npos);
    EXPECT_EQ(fileText(files.front()), before);
  }
}

TEST_F(ExportFormats, AnUnknownFormatIsToldWhichThereAre) {
  const auto found = findExportFormat("vkt");
  ASSERT_FALSE(found);
  EXPECT_NE(found.problems.front().message.find("did you mean \"vtk\"?"), std::string::npos);
  for (const ExportFormat& format : exportFormats())
    EXPECT_NE(found.problems.front().message.find(format.name), std::string::npos);
}

}  // namespace
}  // namespace bedmix::test
