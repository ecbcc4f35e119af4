// SPDX-License-Identifier: MIT
#include "replay/open_recording.h"

#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

/// A snapshot of three particles in a slab that is thin in y; the second one leaves after step 0.
std::string dump(int step) {
  const std::string second = step == 0 ? "2 1 0.03 0.005 0.04 0.002\n" : "";
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" + (step == 0 ? "3" : "2") +
         "\nITEM: BOX BOUNDS ff ff ff\n-0.01 0.09\n0 0.01\n-0.02 0.28\nITEM: ATOMS id type x y z radius\n" +
         "7 2 0.05 0.005 0.0" + std::to_string(1 + step / 100) + " 0.002\n" + second +
         "1 1 -0.01 0.005 -0.02 0.002\n";
}

class OpenRecording : public testing::Test {
 protected:
  Result<OpenedRecording> open(const std::string& name) const {
    ForeignOptions options;
    options.timeStep = 1e-4;
    return openRecording(folder_ / name, options);
  }
  void expectDump(const std::string& name) const {
    auto recording = open(name);
    ASSERT_TRUE(recording) << toString(recording.problems.front());
    EXPECT_EQ(recording->kind, RecordingKind::lammps);
    EXPECT_EQ(recording->frames->times(), (std::vector<double>{0.0, 0.01, 0.02}));
    EXPECT_DOUBLE_EQ(recording->frames->scene().bed.width, 0.1);
    EXPECT_DOUBLE_EQ(recording->frames->scene().bed.height, 0.3);
    EXPECT_EQ(recording->frames->scene().particles.diameter, 0.004);
    const auto last = recording->frames->frame(2);
    ASSERT_TRUE(last) << toString(last.problems.front());
    EXPECT_EQ((*last)->id, (std::vector<std::int32_t>{1, 7}));
    EXPECT_EQ((*last)->species, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ((*last)->position[0], (Vec2f{0.0f, 0.0f}));
    EXPECT_NEAR((*last)->position[1].x, 0.06, 1e-8);
    EXPECT_NEAR((*last)->position[1].y, 0.05, 1e-8);
    EXPECT_EQ((*recording->frames->frame(0))->size(), 3u);
  }
  void expectRefusal(const std::string& name, const std::string& part) const {
    const auto recording = open(name);
    ASSERT_FALSE(recording) << name;
    const std::string found = toString(recording.problems.front());
    EXPECT_NE(found.find(part), std::string::npos) << "'" << part << "' is not in '" << found << "'";
    EXPECT_EQ(recording.problems.front().trouble, Trouble::file);
  }

  TemporaryFolder folder_;
};

TEST_F(OpenRecording, ARunByItsFolderOrTrajectory) {
  const Scene scene = syntheticScene(true, true);
  record(folder_ / "trajectory.h5", scene, 3);
  for (const char* name : {"", "trajectory.h5"}) {
    auto recording = open(name);
    ASSERT_TRUE(recording) << toString(recording.problems.front());
    EXPECT_EQ(recording->kind, RecordingKind::run);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(sameBits(*recording->frames->next(), syntheticFrame(scene, i)));
    EXPECT_FALSE(recording->frames->next());
  }
}

TEST_F(OpenRecording, ADumpAsAFileAFolderOrAPattern) {
  writeText(folder_ / "all.txt", dump(0) + dump(100) + dump(200));
  expectDump("all.txt");
  expectDump("");
  std::filesystem::remove(folder_ / "all.txt");
  for (const int step : {0, 100, 200}) writeText(folder_ / ("dump." + std::to_string(step)), dump(step));
  writeText(folder_ / "notes.md", "not a dump");
  expectDump("");
  expectDump("dump.*");
}

TEST_F(OpenRecording, ACollectionOfVtkFiles) {
  const std::string points = fileText(std::filesystem::path(BEDMIX_SAMPLES) / "vtk/ascii.vtp");
  writeText(folder_ / "a_0.vtp", points);
  writeText(folder_ / "a_1.vtp", points);
  writeText(folder_ / "all.pvd",
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>"
            "<DataSet timestep=\"0.5\" file=\"a_0.vtp\"/><DataSet timestep=\"0.75\" file=\"a_1.vtp\"/>"
            "</Collection></VTKFile>\n");
  ForeignOptions options;
  options.tracerSpecies = 1;
  const auto recording = openRecording(folder_ / "all.pvd", options);
  ASSERT_TRUE(recording) << toString(recording.problems.front());
  EXPECT_EQ(recording->kind, RecordingKind::vtk);
  ASSERT_EQ(recording->frames->times().size(), 2u);
}

TEST_F(OpenRecording, WhatIsNoRecordingIsRefused) {
  expectRefusal("none", "does not exist");
  expectRefusal("none.*", "holds no recording");
  expectRefusal("", "holds no recording");
  writeText(folder_ / "a.csv", "time,lacey\n");
  expectRefusal("a.csv", "is no recording that bedmix knows");
  expectRefusal("", "holds no recording");
  writeText(folder_ / "empty.h5", "");
  expectRefusal("empty.h5", "is empty");
  record(folder_ / "one.h5", syntheticScene(false, false), 1);
  record(folder_ / "two.h5", syntheticScene(false, false), 1);
  expectRefusal("", "holds 2 recordings, the first is one.h5");
  writeText(folder_ / "a.dump", dump(0));
  expectRefusal("", "several kinds, as a.dump and one.h5");
}

}  // namespace
}  // namespace bedmix::test
