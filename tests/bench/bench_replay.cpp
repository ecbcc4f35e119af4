// SPDX-License-Identifier: MIT
// What replaying costs beside reading: a long recorded run of a loose bed, from the page cache.
//   bench_replay [--particles N] [--frames T] [--file FILE]
// Writes FILE where it is not there. Prints for each way the seconds, bytes of particles' data a second, and
// the ratio to a plain read of the same numbers by HDF5.
#include "engine/core/mixing.h"
#include "engine/core/rng.h"
#include "replay/series_log.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <hdf5.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace bedmix::bench {

namespace {

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(toString(result.problems.front()));
  return std::move(*result);
}

/// As deep as wide, half as dense as packed discs.
Scene looseBed(std::int64_t particles) {
  Scene scene;
  scene.name = "loose";
  scene.contacts.restitution = 0.9;
  scene.particles.count = particles;
  scene.bed.width = scene.bed.height =
      scene.particles.diameter * 1.5 * std::sqrt(static_cast<double>(particles) + 1.0);
  const auto side = static_cast<std::int64_t>(std::sqrt(static_cast<double>(particles) / 40.0));
  scene.sampling.columns = scene.sampling.rows = std::max<std::int64_t>(2, side);
  return scene;
}

void record(const std::filesystem::path& file, std::int64_t particles, int frames) {
  const Scene scene = looseBed(particles);
  TrajectoryWriter writer = must(TrajectoryWriter::create(file, scene, {}));
  Frame frame;
  Rng rng(1);
  const auto within = [&](double high) { return static_cast<float>(rng.uniform(0.0, high)); };
  for (std::int64_t i = 0; i < particles; ++i) {
    frame.position.push_back({within(scene.bed.width), within(scene.bed.height)});
    frame.velocity.push_back({within(1.0), within(1.0)});
    frame.species.push_back(frame.position.back().x < static_cast<float>(scene.bed.width / 2));
    frame.id.push_back(static_cast<std::int32_t>(i));
  }
  for (int k = 0; k < frames; ++k) {
    writer.accept(frame);
    if (writer.failure()) throw std::runtime_error(toString(*writer.failure()));
    ++frame.step;
    frame.time += scene.sampling.interval;
  }
  writer.finish();
}

/// The same numbers as the reader hands over, and nothing else.
void readByHdf5(const std::filesystem::path& path, std::size_t frames, std::size_t particles) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  std::vector<float> row(2 * particles);
  for (const char* name : {"particles/all/position/value", "particles/all/velocity/value"}) {
    const hid_t values = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(values);
    const hsize_t count[] = {1, particles, 2};
    const hid_t memory = H5Screate_simple(3, count, nullptr);
    for (hsize_t k = 0; k < frames; ++k) {
      const hsize_t start[] = {k, 0, 0};
      H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
      if (H5Dread(values, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, row.data()) < 0)
        throw std::runtime_error("HDF5 cannot read it");
    }
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(values);
  }
  H5Fclose(file);
}

void readBytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<char> block(1 << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size()))) {
  }
}

template <class Use>
void readFrames(const std::filesystem::path& path, const Use& use) {
  TrajectoryReader reader = must(TrajectoryReader::open(path));
  while (const FramePtr frame = reader.next()) use(*frame);
  if (reader.failure()) throw std::runtime_error(toString(*reader.failure()));
}

template <class Action>
double seconds(const Action& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void compare(const std::filesystem::path& file, std::size_t particles, std::size_t frames) {
  const Scene scene = looseBed(static_cast<std::int64_t>(particles));
  const double bytes = static_cast<double>(4 * sizeof(float) * particles * frames);
  const double plain = seconds([&] { readByHdf5(file, frames, particles); });
  const auto row = [&](const char* what, double took) {
    fmt::print("{:<34}{:8.3f} s {:8.2f} GB/s {:6.2f} x\n", what, took, bytes / took / 1e9, took / plain);
  };
  row("bytes of the file", seconds([&] { readBytes(file); }));
  row("HDF5", plain);
  row("frames", seconds([&] { readFrames(file, [](const Frame&) {}); }));
  row("frames, Lacey's and Ashton's index",
      seconds([&] { readFrames(file, [&](const Frame& f) { mixingSample(f, samplingGrid(scene)); }); }));
  const std::filesystem::path csv = file.string() + ".mixing.csv";
  MixingLog log = must(MixingLog::create(csv, samplingGrid(scene)));
  row("replay", seconds([&] { readFrames(file, [&](const Frame& f) { log.accept(f); }); }));
  std::filesystem::remove(csv);

  std::vector<FramePtr> kept;
  readFrames(file, [&](const Frame& f) {
    if (kept.empty()) kept.push_back(std::make_shared<const Frame>(f));
  });
  row("the indices alone, without reading", seconds([&] {
        for (std::size_t k = 0; k < frames; ++k) mixingSample(*kept.front(), samplingGrid(scene));
      }));
}

}  // namespace

}  // namespace bedmix::bench

int main(int argc, char** argv) {
  std::int64_t particles = 1'000'000;
  int frames = 100;
  std::string file = "bench_replay.h5";
  CLI::App program("What replaying costs beside reading");
  program.add_option("--particles", particles, "")->capture_default_str();
  program.add_option("--frames", frames, "")->capture_default_str();
  program.add_option("--file", file, "")->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  try {
    if (!std::filesystem::exists(file)) bedmix::bench::record(file, particles, frames);
    bedmix::bench::compare(file, static_cast<std::size_t>(particles), static_cast<std::size_t>(frames));
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
