// SPDX-License-Identifier: MIT
#include "replay/reader_process.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "engine/core/scene_reader.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/trajectory_layout.h"

#include <algorithm>
#include <string>

namespace bedmix {

namespace {

// What is said, in this order. The child: trouble, scene; then, where that is sound, trouble, constants. Then
// the parent a request, the child its answer, and so on. Trouble is a text, empty where there is none and the
// rest follows. The numbers of frames go through shared memory, which has room for two: one is taken out of
// the one half while the next is read into the other.

enum class Wanted : std::size_t { frame, checkpoint };
struct Request {
  Wanted wanted;
  FrameRequest of;  // `half` only where a frame is wanted
};

Result<Scene> parse(const SceneText& scene, const std::filesystem::path& file) {
  Result<Scene> parsed = readScene(scene.text, file.string() + ':' + layout::scene);
  for (Diagnostic& problem : parsed.problems) problem.trouble = Trouble::file;
  if (parsed) parsed->name = scene.name;
  return parsed;
}

void putConstants(Channel& to, const RunConstants& constants) {
  to.putAll(constants.provenance.version);
  to.putAll(constants.provenance.commit);
  to.put(constants.events.size());
  for (const RunEvent& event : constants.events) {
    to.put(event.time);
    to.putAll(event.kind);
    to.putAll(event.detail);
  }
  to.put(constants.recorded);
  to.putAll(constants.steps);
  to.putAll(constants.times);
  to.putAll(constants.species);
  to.putAll(constants.id);
  to.putAll(constants.radius);
  to.putAll(constants.kind);
}

RunConstants getConstants(Channel& from) {
  RunConstants constants;
  constants.provenance.version = from.getAll<std::string>();
  constants.provenance.commit = from.getAll<std::string>();
  for (auto left = from.get<std::size_t>(); left > 0; --left) {
    RunEvent& event = constants.events.emplace_back();
    event.time = from.get<double>();
    event.kind = from.getAll<std::string>();
    event.detail = from.getAll<std::string>();
  }
  constants.recorded = from.get<std::size_t>();
  constants.steps = from.getAll<std::vector<std::int64_t>>();
  constants.times = from.getAll<std::vector<double>>();
  constants.species = from.getAll<std::vector<std::uint8_t>>();
  constants.id = from.getAll<std::vector<std::int32_t>>();
  constants.radius = from.getAll<std::vector<float>>();
  constants.kind = from.getAll<std::vector<std::uint8_t>>();
  return constants;
}

/// Copies the first `count` of `room` values from where `at` points and moves it beyond all.
template <class T>
void take(const float*& at, std::size_t count, std::size_t room, std::vector<T>& into) {
  const auto* const values = reinterpret_cast<const T*>(at);
  at = reinterpret_cast<const float*>(values + room);
  into.assign(values, values + count);
}
template <class T>
void take(const float*& at, std::size_t count, std::vector<T>& into) {
  take(at, count, count, into);
}

/// What changes with time where particles come and go; see numbersPerFrame().
void takeFed(const float*& at, std::size_t count, std::size_t room, bool isMixed, Frame& frame) {
  take(at, count, room, frame.id);
  const auto takeBytes = [&](std::vector<std::uint8_t>& into) {
    into.assign(at, at + count);
    at += room;
  };
  takeBytes(frame.species);
  if (!isMixed) return;
  take(at, count, room, frame.radius);
  takeBytes(frame.kind);
}

/// Who is there in a frame of a scene with a feed: ids stand behind `before` columns.
std::size_t countFed(const float* numbers, std::size_t before, std::size_t room) {
  const auto* const id = reinterpret_cast<const std::int32_t*>(numbers + before * room);
  return static_cast<std::size_t>(std::find(id, id + room, -1) - id);
}

/// Makes of a frame of the pool, which is new or was another one of the run, the one of that index.
void fill(Frame& frame, const RunPreamble& run, std::size_t index, const float* numbers) {
  const RunConstants& constants = run.constants;
  const bool isFed = run.scene.effects.find<FeedSettings>() != nullptr;
  const bool friction = run.scene.contacts.friction.has_value();
  const bool heat = run.scene.effects.find<HeatSettings>() != nullptr;
  const bool reaction = run.scene.effects.find<ReactionSettings>() != nullptr;
  const auto room = static_cast<std::size_t>(mostParticles(run.scene));
  const std::size_t n = isFed ? countFed(numbers, 4 + friction + heat + reaction, room) : room;
  frame.step = constants.steps[index];
  frame.time = constants.times[index];
  if (!isFed && frame.id.size() != n) {
    frame.species = constants.species;
    frame.id = constants.id;
    frame.radius = constants.radius;
    frame.kind = constants.kind;
  }
  take(numbers, n, room, frame.position);
  take(numbers, n, room, frame.velocity);
  if (friction) take(numbers, n, room, frame.angularVelocity);
  if (heat) take(numbers, n, room, frame.temperature);
  if (reaction) take(numbers, n, room, frame.content);
  if (isFed) takeFed(numbers, n, room, isMixed(run.scene), frame);
  if (run.scene.gas) {
    const GasGrid grid = makeGasGrid(run.scene);
    const auto cells = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
    take(numbers, cells, frame.gas.voidage);
    take(numbers, cells, frame.gas.pressure);
    take(numbers, cells, frame.gas.velocity);
    if (heat) take(numbers, cells, frame.gas.temperature);
  }
}

float* half(const SharedMemory& memory, std::size_t which, std::size_t numbers) {
  return reinterpret_cast<float*>(memory.data()) + which * numbers;
}

/// All that the child does.
void serve(Channel& parent, const SharedMemory& memory, const std::filesystem::path& file, Reading reading) {
  allowWorkOn(file);
  std::optional<Hdf5Input> in;
  SceneText text;
  std::string trouble = troubleOf([&] { text = readSceneText(in.emplace(file, reading)); });
  parent.putAll(trouble);
  if (!trouble.empty()) return;
  parent.putAll(text.text);
  parent.putAll(text.name);
  const Result<Scene> scene = parse(text, file);
  if (!scene) return;  // the parent finds the same

  std::optional<TrajectoryInput> trajectory;
  trouble = troubleOf([&] { trajectory.emplace(*in, *scene); });
  parent.putAll(trouble);
  if (!trouble.empty()) return;
  putConstants(parent, trajectory->constants());
  const std::size_t numbers = numbersPerFrame(*scene);
  for (;;) {
    const auto request = parent.get<Request>();
    allowWorkOn(file);
    if (request.wanted == Wanted::checkpoint) {
      parent.putAll(trajectory->checkpoint(request.of.index));
      continue;
    }
    parent.putAll(
        troubleOf([&] { trajectory->readFrame(request.of.index, half(memory, request.of.half, numbers)); }));
  }
}

/// As much as two frames of that file may need.
std::size_t roomFor(const std::filesystem::path& file) { return 1 + 2 * std::filesystem::file_size(file); }

}  // namespace

ReaderProcess::ReaderProcess(std::filesystem::path file, Reading reading)
    : file_(std::move(file)),
      memory_(roomFor(file_)),
      child_([this, reading](Channel& parent) { serve(parent, memory_, file_, reading); }) {}

std::optional<Diagnostic> ReaderProcess::trouble() {
  std::string text = child_.channel().getAll<std::string>();
  if (text.empty()) return std::nullopt;
  return fileTrouble(file_, std::move(text));
}

Result<RunPreamble> ReaderProcess::open() {
  if (auto problem = trouble()) return *problem;
  SceneText text;
  text.text = child_.channel().getAll<std::string>();
  text.name = child_.channel().getAll<std::string>();
  Result<Scene> scene = parse(text, file_);
  if (!scene) return std::move(scene.problems);
  if (auto problem = trouble()) return *problem;
  numbers_ = numbersPerFrame(*scene);
  memory_.open(2 * numbers_ * sizeof(float));
  return RunPreamble{std::move(*scene), getConstants(child_.channel())};
}

Result<FramePtr> ReaderProcess::frame(const RunPreamble& run, std::size_t index) {
  Channel& child = child_.channel();
  const auto ask = [&](FrameRequest frame) { child.put(Request{Wanted::frame, frame}); };
  ReadAhead::Read read = ahead_.frame(child, index, run.constants.times.size(), ask);
  if (!read.trouble.empty()) return fileTrouble(file_, std::move(read.trouble));
  const std::shared_ptr<Frame> frame = pool_.take();
  fill(*frame, run, index, half(memory_, read.half, numbers_));
  return FramePtr(frame);
}

std::vector<std::byte> ReaderProcess::checkpoint(std::size_t slot) {
  ahead_.settle(child_.channel());
  child_.channel().put(Request{Wanted::checkpoint, {slot, 0}});
  return child_.channel().getAll<std::vector<std::byte>>();
}

}  // namespace bedmix
