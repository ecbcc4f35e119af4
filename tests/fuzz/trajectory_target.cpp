// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/still_sound.h"
#include "tests/fuzz/temporary_file.h"

#include <fstream>
#include <iterator>

// Trajectories: opened, all read that is in them, and gone on with.

namespace {

using namespace bedmix;
using namespace bedmix::fuzz;

std::string recordedRun(bool effects) {
  const Scene scene = smallScene(effects);
  Simulation simulation = *std::move(Simulation::make(scene).value);
  {
    auto writer = TrajectoryWriter::create(temporaryPath(), scene, {"1.0", "0123456789ab"});
    require(bool(writer), "a file for trajectories can be written");
    for (int frame = 0; frame < 3; ++frame) {
      writer->accept(*simulation.frame());
      writer->keep(writeCheckpoint(simulation, scene, 1.5));
      require(!simulation.advance(stepsPerFrame(scene)), "the small run runs");
    }
    writer->finish();
  }
  std::ifstream in(temporaryPath(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Goes on with the run after its frame before the last one, with other frames than were there.
void requireSoundResume(const Scene& scene, Frame frame, std::size_t frames) {
  auto writer = TrajectoryWriter::resume(temporaryPath(), scene, frames, 0);
  if (!writer) return require(!writer.problems.front().message.empty(), "a refusal has a reason");
  for (int i = 0; i < 2; ++i) {
    ++frame.step;
    frame.time += 1.0;
    writer->accept(frame);
    writer->keep(std::vector<std::byte>(5000));
  }
  writer->finish();
}

}  // namespace

namespace bedmix::fuzz {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> recorded{recordedRun(false), recordedRun(true)};
  return recorded;
}

void mutate(std::string& input, Rng& rng) { mutateBytes(input, rng); }

}  // namespace bedmix::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  writeTemporary(data, size);
  auto reader = TrajectoryReader::open(temporaryPath());
  if (!reader) {
    require(!reader.problems.empty() && !reader.problems.front().message.empty(), "a refusal has a reason");
    return 0;
  }
  reader->provenance();
  reader->checkpoints();
  std::size_t frames = 0;
  FramePtr last;
  for (; const FramePtr frame = reader->next(); ++frames) {
    requireFinite(*frame);
    last = frame;
  }
  require(frames == reader->times().size() || reader->failure(), "a frame that is missing has a reason");
  if (last) requireSoundResume(reader->scene(), *last, frames - 1);
  return 0;
}
