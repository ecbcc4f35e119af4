// SPDX-License-Identifier: MIT
#include "tests/replay/synthetic.h"

#include "engine/core/particle_list.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>

namespace bedmix::test {

Scene syntheticScene(bool gas, bool friction, int particles) {
  Scene scene;
  scene.name = "synthetic";
  scene.title = "Grains à la \"carte\"";
  scene.seed = 0xfedcba9876543210ull >> 1;
  scene.bed = {0.048, 0.12, 0.004, BedTop::open};
  scene.particles.count = particles;
  scene.contacts.restitution = 0.9;
  if (friction) scene.contacts.friction.emplace();
  if (gas) {
    scene.gas.emplace();
    scene.gas->grid = {{{4, 0.012}}, {{10, 0.012}}};
    scene.gas->inlets = {{0.0, 0.048, std::nullopt, 2.0}};
  }
  scene.sampling = {2, 3, 5, 0.01};
  scene.flux = {0.024, 0.0, 0.04};
  return scene;
}

void addHeat(Scene& scene) {
  HeatSettings& heat = scene.effects.at<HeatSettings>().emplace();
  heat.heatCapacity = 840.0;
  heat.conductivity = 1.0;
  heat.temperature = 300.0;
  if (scene.gas) heat.gas.emplace();
}

void addFeed(Scene& scene) {
  scene.particles.species.push_back({"other", 0, 0.003, {}, {}});
  FeedSettings& feed = scene.effects.at<FeedSettings>().emplace();
  feed.most = scene.particles.count + 3;
  feed.streams = {{.species = "other", .rate = 100.0, .from = 0.0, .to = 0.02, .y = 0.1}};
}

Frame syntheticFrame(const Scene& scene, int index) {
  Rng rng(static_cast<std::uint64_t>(index) + 1000);
  const auto draw = [&](double low, double high) { return static_cast<float>(rng.uniform(low, high)); };
  Frame frame;
  frame.step = std::int64_t{1000} * index;
  frame.time = index / 100.0;
  // With a feed some have come and others gone.
  const bool isFed = scene.effects.find<FeedSettings>() != nullptr;
  const auto most = static_cast<int>(mostParticles(scene));
  const int count = isFed ? 7 * index % (most + 1) : most;
  for (int i = 0; i < count; ++i) {
    frame.position.push_back({draw(0.0, 0.048), draw(0.0, 0.12)});
    frame.velocity.push_back({draw(-2.0, 2.0), i % 7 == 0 ? -0.0f : draw(-1e-39, 1e-39)});
    if (scene.contacts.friction) frame.angularVelocity.push_back(draw(-1e3, 1e3));
    if (scene.effects.find<HeatSettings>()) frame.temperature.push_back(draw(250.0, 900.0));
    if (scene.effects.find<ReactionSettings>()) frame.content.push_back(draw(0.0, 0.1));
    frame.species.push_back(i % 3 == 0);
    frame.id.push_back(isFed ? index / 2 + 2 * i : i);
    if (!isFed || !isMixed(scene)) continue;
    frame.kind.push_back(i % 2 == 0);
    frame.radius.push_back(draw(1e-3, 2e-3));
  }
  if (scene.gas) {
    for (int c = 0; c < 40; ++c) {
      frame.gas.voidage.push_back(draw(0.36, 1.0));
      frame.gas.pressure.push_back(draw(-10.0, 2000.0));
      frame.gas.velocity.push_back({draw(-3.0, 3.0), draw(-3.0, 9.0)});
      if (scene.effects.find<HeatSettings>()) frame.gas.temperature.push_back(draw(250.0, 900.0));
    }
  }
  return frame;
}

namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  const auto bytes = [](const std::vector<T>& v) { return std::as_bytes(std::span(v)); };
  return std::ranges::equal(bytes(a), bytes(b));
}

}  // namespace

bool sameBits(const Frame& a, const Frame& b) {
  return a.step == b.step && std::bit_cast<std::uint64_t>(a.time) == std::bit_cast<std::uint64_t>(b.time) &&
         sameBytes(a.position, b.position) && sameBytes(a.velocity, b.velocity) &&
         sameBytes(a.angularVelocity, b.angularVelocity) && sameBytes(a.temperature, b.temperature) &&
         sameBytes(a.gas.temperature, b.gas.temperature) && a.species == b.species && a.id == b.id &&
         sameBytes(a.radius, b.radius) && sameBytes(a.content, b.content) && a.kind == b.kind &&
         sameBytes(a.gas.voidage, b.gas.voidage) && sameBytes(a.gas.pressure, b.gas.pressure) &&
         sameBytes(a.gas.velocity, b.gas.velocity);
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "bedmix-test-XXXXXX").string();
  if (!mkdtemp(name.data())) std::abort();
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void record(const std::filesystem::path& path, const Scene& scene, int frames) {
  auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer) << toString(writer.problems.front());
  for (int i = 0; i < frames; ++i) writer->accept(syntheticFrame(scene, i));
  ASSERT_FALSE(writer->failure()) << toString(*writer->failure());
}

Playback playBack(const std::filesystem::path& path, const Scene& scene) {
  auto reader = TrajectoryReader::open(path);
  if (!reader) return {0, toString(reader.problems.front())};
  int frames = 0;
  for (; const FramePtr frame = reader->next(); ++frames)
    EXPECT_TRUE(sameBits(*frame, syntheticFrame(scene, frames))) << "frame " << frames;
  EXPECT_FALSE(reader->failure()) << toString(*reader->failure());
  EXPECT_EQ(reader->times().size(), static_cast<std::size_t>(frames));
  return {static_cast<std::size_t>(frames), ""};
}

}  // namespace bedmix::test
