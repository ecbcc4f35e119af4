// SPDX-License-Identifier: MIT
#include "replay/series_log.h"

#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix::test {
namespace {

/// Four particles in two cells of a bed of 2 x 1 m; three left of its middle.
Frame fourParticles() {
  Frame frame;
  frame.time = 0.07;
  frame.position = {{0.5f, 0.5f}, {0.25f, 0.5f}, {0.75f, 0.25f}, {1.5f, 0.5f}};
  frame.velocity = {{-1.0f, 0.0f}, {0.0f, 0.0f}, {0.0f, 0.0f}, {0.0f, 0.0f}};
  frame.species = {1, 0, 0, 1};
  frame.id = {0, 1, 2, 3};
  return frame;
}

TEST(MixingLog, WritesShortestDecimalsAndEmptyFields) {
  const TemporaryFolder folder;
  auto log = MixingLog::create(folder / "mixing.csv", {2, 1, 1, 2.0, 1.0});
  ASSERT_TRUE(log);
  Frame frame = fourParticles();
  log->accept(frame);  // fractions 1/3 and 1: S^2 = 2/9, sigma_0^2 = 2/9, sigma_r^2 = 1/9
  frame.time = 0.08;
  frame.species = {0, 0, 0, 0};
  log->accept(frame);
  frame.time = 1e-7;
  frame.position.assign(4, {5.0f, 5.0f});
  log->accept(frame);
  ASSERT_FALSE(log->failure());
  const std::string text = fileText(folder / "mixing.csv");
  const auto header = text.substr(0, text.find('\n'));
  EXPECT_EQ(header, "time,lacey,ashton,stddev,tracer_mean,cells,particles_per_cell,counted_fraction");

  const auto table = readCsv(folder / "mixing.csv");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows(), 3u);
  EXPECT_NEAR(*table->find("lacey")->at(0), 0.0, 1e-15);
  EXPECT_NEAR(*table->find("stddev")->at(0), std::sqrt(2.0) / 3, 1e-15);
  EXPECT_NEAR(*table->find("tracer_mean")->at(0), 2.0 / 3, 1e-15);
  const auto rest = text.substr(text.find("0.08"));
  EXPECT_EQ(rest, "0.08,,,0,0,2,2,1\n1e-07,,,,,0,,0\n");
}

TEST(FluxLog, WritesOneRowAFrame) {
  Scene scene;
  scene.bed.thickness = 0.004;
  scene.flux = {0.5, 0.0, 1.0};
  const TemporaryFolder folder;
  auto log = FluxLog::create(folder / "flux.csv", scene);
  ASSERT_TRUE(log);
  Frame frame = fourParticles();
  log->accept(frame);
  frame.velocity[0].x = 0.0f;
  frame.time = 10.0;
  log->accept(frame);
  // One particle, at 1 m/s, over a strip of two diameters by 1 m by the thickness.
  const double flux = particleMass(scene) / (2 * 0.004 * 1.0 * 0.004);
  const auto table = readCsv(folder / "flux.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->names, (std::vector<std::string>{"time", "flux"}));
  EXPECT_NEAR(*table->columns[1][0], flux, 1e-12);
  EXPECT_EQ(fileText(folder / "flux.csv").substr(fileText(folder / "flux.csv").find("\n10,")), "\n10,0\n");
}

TEST(PressureLog, WritesDropAndHeight) {
  const Scene scene = syntheticScene(true, true);
  Frame frame = syntheticFrame(scene, 2);
  frame.gas.pressure.assign(40, 1284.5f);
  frame.position.assign(60, {0.01f, 0.0625f});
  const TemporaryFolder folder;
  auto log = PressureLog::create(folder / "pressure.csv", scene);
  ASSERT_TRUE(log);
  log->accept(frame);
  EXPECT_EQ(fileText(folder / "pressure.csv"), "time,pressure_drop,bed_height\n0.02,1284.5,0.0645\n");
}

TEST(HeatLog, WritesMeansAndHeat) {
  for (const bool gas : {true, false}) {
    Scene scene = syntheticScene(gas, false, 4);
    addHeat(scene);
    Frame frame = syntheticFrame(scene, 2);
    frame.temperature = {300.0f, 300.0f, 320.0f, 340.0f};
    if (gas) {
      frame.gas.temperature.assign(40, 300.0f);
      frame.gas.voidage.assign(40, 1.0f);
      frame.gas.velocity.assign(40, {0.0f, 1.0f});
      // Of the topmost cells one lets three times as much out, another nothing.
      frame.gas.temperature[36] = 400.0f;
      frame.gas.velocity[36].y = 3.0f;
      frame.gas.velocity[39].y = -1.0f;
    }
    const TemporaryFolder folder;
    auto log = HeatLog::create(folder / "heat.csv", scene);
    ASSERT_TRUE(log);
    log->accept(frame);
    const auto table = readCsv(folder / "heat.csv");
    ASSERT_TRUE(table);
    EXPECT_EQ(table->names, (std::vector<std::string>{"time", "particle_temperature", "outlet_temperature",
                                                      "particle_heat"}));
    EXPECT_DOUBLE_EQ(*table->columns[1][0], 315.0);
    EXPECT_EQ(table->columns[2][0].has_value(), gas);
    EXPECT_NEAR(table->columns[2][0].value_or(360.0), 360.0, 1e-9);
    EXPECT_NEAR(*table->columns[3][0], particleMass(scene) * 840.0 * 60.0, 1e-12);
  }
}

TEST(FeedLog, CountsWhoCameAndWent) {
  Scene scene = syntheticScene(false, false, 4);
  scene.effects.at<FeedSettings>().emplace().most = 10;
  const TemporaryFolder folder;
  auto log = FeedLog::create(folder / "feed.csv", scene);
  ASSERT_TRUE(log);
  Frame frame = syntheticFrame(scene, 1);
  frame.position.resize(2);
  for (const std::vector<std::int32_t>& id :
       {std::vector<std::int32_t>{0, 3}, {1, 6}, {1, 2}}) {  // 4 and 5 came and went unseen
    frame.id = id;
    frame.time += 1.0;
    log->accept(frame);
  }
  const auto table = readCsv(folder / "feed.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->names, (std::vector<std::string>{"time", "particles", "mass", "entered", "left"}));
  EXPECT_EQ(table->columns[1], (Table::Column{2.0, 2.0, 2.0}));
  EXPECT_NEAR(*table->columns[2][1], 2.0 * particleMass(scene), 1e-15);
  EXPECT_EQ(table->columns[3], (Table::Column{0.0, 3.0, 3.0}));
  EXPECT_EQ(table->columns[4], (Table::Column{2.0, 5.0, 5.0}));
}

TEST(SeriesLogs, LiveAndReplayedAreTheSameBytes) {
  const Scene scene = syntheticScene(true, true, 500);
  const TemporaryFolder folder;
  const auto logInto = [&](const std::string& name, FrameSource& source, FrameSink* also) {
    auto mixing = MixingLog::create(folder / (name + "-mixing.csv"), samplingGrid(scene));
    auto flux = FluxLog::create(folder / (name + "-flux.csv"), scene);
    auto pressure = PressureLog::create(folder / (name + "-pressure.csv"), scene);
    ASSERT_TRUE(mixing && flux && pressure);
    std::vector<FrameSink*> sinks{&*mixing, &*flux, &*pressure};
    if (also) sinks.push_back(also);
    drain(source, sinks);
  };
  struct Live final : FrameSource {
    const Scene& scene;
    int index = 0;
    explicit Live(const Scene& s) : scene(s) {}
    FramePtr next() override {
      return index < 100 ? std::make_shared<Frame>(syntheticFrame(scene, index++)) : nullptr;
    }
  };
  {
    Live live(scene);
    auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
    ASSERT_TRUE(writer);
    logInto("live", live, &*writer);
  }
  auto reader = TrajectoryReader::open(folder.path());
  ASSERT_TRUE(reader);
  logInto("replayed", *reader, nullptr);
  for (const char* series : {"-mixing.csv", "-flux.csv", "-pressure.csv"}) {
    const std::string live = fileText(folder / (std::string("live") + series));
    EXPECT_GT(live.size(), 1000u);
    EXPECT_EQ(live, fileText(folder / (std::string("replayed") + series)));
  }
}

TEST(SeriesLogs, SayWhereTheyCannotBeWritten) {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  const auto log = MixingLog::create(folder / "file/mixing.csv", {});
  ASSERT_FALSE(log);
  EXPECT_EQ(log.problems.front().trouble, Trouble::file);
  EXPECT_NE(toString(log.problems.front()).find("Not a directory"), std::string::npos);
}

}  // namespace
}  // namespace bedmix::test
