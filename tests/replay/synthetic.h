// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/rng.h"
#include "engine/core/scene.h"

#include <filesystem>
#include <string>
#include <vector>

// Runs that no solver made: quick, exact, and full of values that are awkward to store.

namespace bedmix::test {

/// A small bed; with the effects asked for.
Scene syntheticScene(bool gas, bool friction, int particles = 60);
void addHeat(Scene& scene);
/// Particles of two kinds come and go.
void addFeed(Scene& scene);

/// Frame `index` of a run of that scene: a function of its index alone, so that any process can tell what a
/// frame must be.
Frame syntheticFrame(const Scene& scene, int index);

/// Whether all the bits are the same.
bool sameBits(const Frame& a, const Frame& b);

/// A folder of the test's own, empty at its start and removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string fileText(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);

/// Records the frames 0 to `frames` - 1 of the scene, and fails the test where that fails.
void record(const std::filesystem::path& path, const Scene& scene, int frames);

/// Reads a trajectory and expects frames 0 to some last one, each bit as it was made. Returns how many; 0,
/// with the reader's message for the test to judge, where it does not open.
struct Playback {
  std::size_t frames = 0;
  std::string message;
};
Playback playBack(const std::filesystem::path& path, const Scene& scene);

}  // namespace bedmix::test
