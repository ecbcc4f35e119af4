// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "engine/core/hash.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/still_sound.h"

#include <cstring>

// Checkpoints: restored for the scene they were written of and one other; what is accepted goes on.

namespace {

using namespace bedmix;
using namespace bedmix::fuzz;

const Scene& sceneWith(bool effects) {
  static const Scene scenes[] = {smallScene(false), smallScene(true)};
  return scenes[effects];
}

/// Lets the checksum at the end fit again, so that what stands before it is looked at.
void reseal(std::string& checkpoint) {
  constexpr std::size_t sizeAt = 2 * sizeof(std::uint64_t), least = 8 * sizeof(std::uint64_t);
  std::uint64_t size = checkpoint.size();
  if (size < least + sizeof size) return;
  std::memcpy(checkpoint.data() + sizeAt, &size, sizeof size);
  StateHash sum;
  sum.add(std::as_bytes(std::span(checkpoint).first(size - sizeof size)));
  const std::uint64_t value = sum.value();
  std::memcpy(checkpoint.data() + size - sizeof value, &value, sizeof value);
}

}  // namespace

namespace bedmix::fuzz {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> written = [] {
    std::vector<std::string> checkpoints;
    for (const bool effects : {false, true}) {
      const Scene& scene = sceneWith(effects);
      Simulation simulation = *std::move(Simulation::make(scene).value);
      for (int part = 0; part < 2; ++part) {
        const std::vector<std::byte> bytes = writeCheckpoint(simulation, scene, 1.5);
        checkpoints.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        require(!simulation.advance(3000), "the small run runs");
      }
    }
    return checkpoints;
  }();
  return written;
}

void mutate(std::string& input, Rng& rng) {
  mutateBytes(input, rng);
  if (below(8, rng) != 0) reseal(input);
}

}  // namespace bedmix::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes = std::as_bytes(std::span(data, size));
  const bool isWhole = checkpointMark(bytes).has_value();
  for (const bool effects : {false, true}) {
    Result<Resumed> resumed = readCheckpoint(bytes, sceneWith(effects), 1);
    require(resumed || !resumed.problems.empty(), "a refusal has a reason");
    if (!resumed) continue;
    require(isWhole, "what can be resumed is whole");
    requireSoundSteps(resumed->simulation);
  }
  return 0;
}
