// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/still_sound.h"

#include <algorithm>
#include <string_view>

// Scene files: read and checked; those that pass are written and read back, and small ones simulated.

namespace {

using namespace bedmix;
using namespace bedmix::fuzz;

std::int64_t cells(const std::vector<GridSpan>& spans) {
  std::int64_t sum = 0;
  for (const GridSpan& span : spans) sum += span.count;
  return sum;
}

/// A scene that 100 steps of take well below a second; none where it cannot be cut down to that.
bool makeSmall(Scene& scene) {
  constexpr std::int64_t particles = 60, gasCells = 1000, fallSteps = 2000;
  scene.particles.count = std::min(scene.particles.count, particles);
  if (3.0 / scene.time.step.valueOr(longestStep(scene)) > fallSteps)
    scene.start.arrangement = Arrangement::drop;
  if (scene.gas) {
    const std::int64_t columns = cells(scene.gas->grid.columns), rows = cells(scene.gas->grid.rows);
    if (columns > gasCells || rows > gasCells || columns * rows > gasCells) return false;
    scene.gas->maxIterations = std::min<std::int64_t>(scene.gas->maxIterations, 5);
  }
  return contradictions(scene).empty();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Result<Scene> scene = readScene(text, "scene.toml");
  if (!scene) {
    require(!scene.problems.empty(), "a refusal has a reason");
    return 0;
  }
  const std::string written = writeScene(*scene);
  const Result<Scene> again = readScene(written, "scene.toml");
  require(bool(again), "a scene that was written can be read");
  require(writeScene(*again) == written, "a scene that was written is read as it was");

  if (!makeSmall(*scene)) return 0;
  Result<Simulation> simulation = Simulation::make(*scene);
  if (simulation)
    requireSoundSteps(*simulation);
  else
    require(!simulation.problems.empty(), "a refusal has a reason");
  return 0;
}
