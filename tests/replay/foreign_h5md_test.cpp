// SPDX-License-Identifier: MIT
#include "engine/core/mixing.h"
#include "tests/replay/foreign_files.h"

#include <fstream>
#include <sstream>

namespace bedmix::test {
namespace {

using ForeignH5md = ForeignFiles;

/// What foreign_h5md.py says must be in a frame.
struct Expected {
  std::vector<std::int32_t> id;
  std::vector<Vec2f> position, velocity;
  std::vector<std::uint8_t> species;
};

std::vector<Expected> expectedFrames(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<Expected> frames;
  for (std::int64_t n = 0; in.read(reinterpret_cast<char*>(&n), sizeof n);) {
    Expected& e = frames.emplace_back();
    const auto read = [&](auto& list) {
      list.resize(static_cast<std::size_t>(n));
      in.read(reinterpret_cast<char*>(list.data()), n * static_cast<std::int64_t>(sizeof list.front()));
    };
    read(e.id), read(e.position), read(e.velocity), read(e.species);
  }
  return frames;
}

TEST_F(ForeignH5md, FramesAreThoseThatWereWrittenInAnyOrder) {
  const auto recorded = open("slab");
  ASSERT_TRUE(recorded);
  const std::vector<Expected> expected = expectedFrames(folder_ / "slab.frames");
  ASSERT_EQ(recorded->times().size(), expected.size());
  for (const std::size_t index : {0, 1, 2, 3, 4, 2, 0, 4, 4}) {
    const auto frame = recorded->frame(index);
    ASSERT_TRUE(frame) << toString(frame.problems.front());
    const Expected& e = expected[index];
    EXPECT_EQ((*frame)->id, e.id);
    EXPECT_EQ((*frame)->position, e.position);
    EXPECT_EQ((*frame)->velocity, e.velocity);
    EXPECT_EQ((*frame)->species, e.species);
    EXPECT_EQ((*frame)->step, 1000 + 250 * static_cast<std::int64_t>(index));
    EXPECT_EQ((*frame)->time, 0.02 + 0.005 * static_cast<double>(index));
    EXPECT_EQ((*frame)->size(), 2000u - 40 * index);
    EXPECT_TRUE((*frame)->angularVelocity.empty());
  }
}

TEST_F(ForeignH5md, SceneIsThatOfTheFile) {
  const auto recorded = open("slab");
  ASSERT_TRUE(recorded);
  const Scene& scene = recorded->scene();
  EXPECT_EQ(scene.name, "slab.h5");
  EXPECT_EQ(scene.bed.width, 0.1);
  EXPECT_EQ(scene.bed.height, 0.3);
  EXPECT_EQ(scene.bed.thickness, 0.012);
  EXPECT_NEAR(scene.particles.diameter, 0.0022, 1e-15);
  EXPECT_EQ(scene.particles.count, 2000);
  EXPECT_FALSE(scene.gas);
  EXPECT_FALSE(scene.contacts.friction);
  EXPECT_DOUBLE_EQ(scene.sampling.interval, 0.005);
  EXPECT_DOUBLE_EQ(scene.time.duration, 0.04);
}

TEST_F(ForeignH5md, IndicesAreThoseOfAnIndependentComputation) {
  const auto recorded = open("slab");
  ASSERT_TRUE(recorded);
  const SamplingGrid grid = samplingGrid(recorded->scene());
  std::ifstream in(folder_ / "slab.indices");
  for (std::size_t index = 0; index < recorded->times().size(); ++index) {
    std::string line;
    ASSERT_TRUE(std::getline(in, line));
    std::istringstream words(line);
    int cells = 0;
    double lacey = 0.0, ashton = 0.0;
    words >> cells >> lacey >> ashton;
    const auto frame = recorded->frame(index);
    ASSERT_TRUE(frame);
    const CellCounts counts = countCells(**frame, grid);
    for (const auto* list : {&counts.all, &counts.tracer})
      for (const std::int32_t count : *list) {
        int expected = -1;
        words >> expected;
        ASSERT_EQ(count, expected);
      }
    const MixingSample sample = mixingSample(**frame, grid);
    EXPECT_EQ(sample.cells, cells);
    EXPECT_NEAR(sample.lacey.value(), lacey, 1e-12);
    EXPECT_NEAR(sample.ashton.value(), ashton, 1e-12);
  }
}

TEST_F(ForeignH5md, OneGroupKeepsItsIds) {
  ForeignOptions options;
  options.group = "fine";
  const auto recorded = open("slab", options);
  ASSERT_TRUE(recorded);
  const auto last = recorded->frame(4);
  ASSERT_TRUE(last);
  EXPECT_EQ((*last)->size(), 920u);
  EXPECT_EQ((*last)->id.front(), 4);
  EXPECT_EQ((*last)->id.back(), 999);
  const auto first = recorded->frame(0);
  ASSERT_TRUE(first);
  for (std::size_t i = 0; i < (*last)->size(); ++i) {  // without species: tagged by where they were at first
    const float x = (*first)->position[static_cast<std::size_t>((*last)->id[i])].x;
    ASSERT_EQ((*last)->species[i], x < 0.05f);
  }
  options.group = "find";
  EXPECT_NE(message("slab", options).find("it has coarse, fine"), std::string::npos);
}

TEST_F(ForeignH5md, EnumsMatricesSpinAndUnequalTimes) {
  const auto recorded = open("flat");
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->times(), (std::vector<double>{0.0, 0.1, 0.1 * 4, 0.1 * 9, 0.1 * 16}));
  EXPECT_NEAR(recorded->scene().bed.width, 0.2, 1e-15);
  EXPECT_EQ(recorded->scene().particles.diameter, 0.004);
  EXPECT_DOUBLE_EQ(recorded->scene().sampling.interval, 0.4);
  EXPECT_TRUE(recorded->scene().contacts.friction);
  const auto frame = recorded->frame(3);
  ASSERT_TRUE(frame);
  EXPECT_EQ((*frame)->step, 9);
  for (std::size_t i = 0; i < 60; ++i) {
    const std::size_t row = 59 - i;  // in the file, where ids count down from 60
    EXPECT_EQ((*frame)->id[i], static_cast<std::int32_t>(i) + 1);
    EXPECT_EQ((*frame)->species[i], row % 3 == 0);
    EXPECT_EQ((*frame)->angularVelocity[i], 60.0f * 3 + static_cast<float>(row));
    EXPECT_GE((*frame)->position[i].x, 0.0f);
    EXPECT_EQ((*frame)->velocity[i], Vec2f{});
  }
}

TEST_F(ForeignH5md, StepsAloneNeedTheLengthOfOne) {
  ForeignOptions options;
  options.diameter = 0.004;
  EXPECT_NE(message("bare", options).find("give --time-step"), std::string::npos);
  options.timeStep = 0.001;
  const auto recorded = open("bare", options);
  ASSERT_TRUE(recorded);
  EXPECT_DOUBLE_EQ(recorded->times().back(), 0.04);
  options.diameter.reset();
  EXPECT_NE(message("bare", options).find("give --diameter"), std::string::npos);
}

TEST_F(ForeignH5md, WithoutABoxTheBedIsWhereParticlesEverAre) {
  ForeignOptions options;
  options.diameter = 0.004;
  options.timeStep = 0.001;
  const auto recorded = open("bare", options);
  ASSERT_TRUE(recorded);
  Vec2f low{1.0f, 1.0f}, high{};
  while (const FramePtr frame = recorded->next())
    for (const Vec2f at : frame->position) {
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  EXPECT_FLOAT_EQ(low.x, 0.002f);
  EXPECT_FLOAT_EQ(low.y, 0.002f);
  EXPECT_NEAR(recorded->scene().bed.width - static_cast<double>(high.x), 0.002, 1e-7);
  EXPECT_NEAR(recorded->scene().bed.height - static_cast<double>(high.y), 0.002, 1e-7);
  EXPECT_LT(recorded->scene().bed.width, 0.104);

  options.bed = PlaneBox{{-0.01, -0.02}, {0.11, 0.5}};
  const auto inBed = open("bare", options);
  ASSERT_TRUE(inBed);
  EXPECT_DOUBLE_EQ(inBed->scene().bed.width, 0.12);
  EXPECT_DOUBLE_EQ(inBed->scene().bed.height, 0.52);
}

TEST_F(ForeignH5md, ASnapshotIsAFrame) {
  EXPECT_NE(message("snapshot").find("species 0, 1, 2; say which is the tracer"), std::string::npos);
  ForeignOptions options;
  options.tracerSpecies = 2;
  const auto recorded = open("snapshot", options);
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->times(), std::vector<double>{0.0});
  const FramePtr frame = recorded->next();
  ASSERT_TRUE(frame);
  EXPECT_FALSE(recorded->next());
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(frame->species[i], i % 3 == 2);
  options.tracerSpecies = 3;
  EXPECT_NE(message("snapshot", options).find("no particle of species 3"), std::string::npos);
}

TEST_F(ForeignH5md, ASceneGivesBedAndSamplingButNoGas) {
  ForeignOptions options;
  options.scene = syntheticScene(true, true);
  options.scene->floor = {10.0, FloorShape::stair};
  const auto recorded = open("slab", options);
  ASSERT_TRUE(recorded);
  const Scene& scene = recorded->scene();
  EXPECT_EQ(scene.name, "synthetic");
  EXPECT_EQ(scene.bed.width, 0.048);
  EXPECT_EQ(scene.sampling.rows, 3);
  EXPECT_EQ(scene.floor.shape, FloorShape::straight);
  EXPECT_TRUE(scene.flux);
  EXPECT_FALSE(scene.gas);
  EXPECT_FALSE(scene.contacts.friction);
  EXPECT_EQ(scene.particles.count, 2000);

  options.scene->bed.width = 0.04;
  options.scene->flux->x = 0.05;
  EXPECT_NE(message("slab", options).find("leaves the bed"), std::string::npos);
}

TEST(PlaneView, SpinIsCounterClockwiseAsItIsSeen) {
  // The velocity w x r of a point right of the axis is up, where w is seen to turn counter-clockwise.
  for (const ViewPlane plane : {ViewPlane::xy, ViewPlane::xz, ViewPlane::yz}) {
    const PlaneView view(plane);
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3d w{}, r{};
      w[k] = 2.0;
      r[plane == ViewPlane::yz ? 1 : 0] = 1.0;
      const Vec3d v{w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]};
      EXPECT_EQ(view.spin(w), view(v).y);
    }
  }
}

TEST(PlaneView, LooksAlongTheThinnestDirection) {
  const auto plane = [](double x, double y, double z) { return flattestPlane({{}, {x, y, z}}); };
  EXPECT_EQ(plane(1.0, 0.1, 2.0), ViewPlane::xz);
  EXPECT_EQ(plane(1.0, 2.0, 0.1), ViewPlane::xy);
  EXPECT_EQ(plane(0.1, 2.0, 1.0), ViewPlane::yz);
  EXPECT_EQ(plane(1.0, 1.0, 1.0), ViewPlane::xz);
}

}  // namespace
}  // namespace bedmix::test
