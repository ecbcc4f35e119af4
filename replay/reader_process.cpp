// SPDX-License-Identifier: MIT
#include "replay/reader_process.h"

#include "engine/core/gas_grid.h"
#include "engine/core/scene_reader.h"
#include "replay/file_trouble.h"
#include "replay/trajectory_layout.h"

#include <functional>
#include <new>
#include <string>

namespace bedmix {

namespace {

// What is said, in this order. The child: trouble, scene; then, where that is sound, trouble, constants. Then
// the parent a request, the child its answer, and so on. Trouble is a text, empty where there is none and the
// rest follows.

enum class Wanted { frame, checkpoint };
struct Request {
  Wanted wanted;
  std::size_t index;
};

Result<Scene> parse(const SceneText& scene, const std::filesystem::path& file) {
  Result<Scene> parsed = readScene(scene.text, file.string() + ':' + layout::scene);
  for (Diagnostic& problem : parsed.problems) problem.trouble = Trouble::file;
  if (parsed) parsed->name = scene.name;
  return parsed;
}

/// What is wrong with what is read, for the parent.
std::string troubleOf(const std::function<void()>& read) {
  try {
    read();
    return "";
  } catch (const std::bad_alloc&) {
    return "asks for more memory than this machine has; it is damaged, or from a larger one";
  } catch (const std::exception& e) {
    return e.what();
  }
}

/// An honest file needs a thousandth of it.
std::chrono::seconds patience(const std::filesystem::path& file) {
  constexpr std::uintmax_t bytesPerSecond = 20'000'000;
  return std::chrono::seconds(5 + std::filesystem::file_size(file) / bytesPerSecond);
}

void putConstants(Channel& to, const RunConstants& constants) {
  to.putAll(constants.provenance.version);
  to.putAll(constants.provenance.commit);
  to.putAll(constants.steps);
  to.putAll(constants.times);
  to.putAll(constants.species);
  to.putAll(constants.id);
}

RunConstants getConstants(Channel& from) {
  RunConstants constants;
  constants.provenance.version = from.getAll<std::string>();
  constants.provenance.commit = from.getAll<std::string>();
  constants.steps = from.getAll<std::vector<std::int64_t>>();
  constants.times = from.getAll<std::vector<double>>();
  constants.species = from.getAll<std::vector<std::uint8_t>>();
  constants.id = from.getAll<std::vector<std::int32_t>>();
  return constants;
}

void putFrame(Channel& to, const Frame& frame) {
  to.putValues(frame.position);
  to.putValues(frame.velocity);
  to.putValues(frame.angularVelocity);
  to.putValues(frame.gas.voidage);
  to.putValues(frame.gas.pressure);
  to.putValues(frame.gas.velocity);
}

FramePtr getFrame(Channel& from, const RecordedRun& run, std::size_t index) {
  const auto& [provenance, steps, times, species, id] = run.constants;
  const std::size_t n = species.size();
  auto frame = std::make_shared<Frame>();
  frame->step = steps[index];
  frame->time = times[index];
  frame->species = species;
  frame->id = id;
  frame->position = from.getValues<Vec2f>(n);
  frame->velocity = from.getValues<Vec2f>(n);
  if (run.scene.contacts.friction) frame->angularVelocity = from.getValues<float>(n);
  if (run.scene.gas) {
    const GasGrid grid = makeGasGrid(run.scene);
    const auto cells = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
    frame->gas.voidage = from.getValues<float>(cells);
    frame->gas.pressure = from.getValues<float>(cells);
    frame->gas.velocity = from.getValues<Vec2f>(cells);
  }
  return frame;
}

constexpr std::size_t noFrame = static_cast<std::size_t>(-1);

/// A frame that has been read, or why not.
struct ReadFrame {
  std::size_t index = noFrame;
  Frame frame;
  std::string trouble;
};

ReadFrame read(const TrajectoryInput& in, std::size_t index) {
  ReadFrame read{index, {}, {}};
  read.trouble = troubleOf([&] { read.frame = in.frame(index); });
  return read;
}

void answer(Channel& parent, const TrajectoryInput& in, const std::filesystem::path& file) {
  ReadFrame ahead;
  for (std::size_t last = noFrame;;) {
    const auto request = parent.get<Request>();
    ChildProcess::allow(patience(file));
    if (request.wanted == Wanted::checkpoint) {
      parent.putAll(in.checkpoint(request.index));
      continue;
    }
    if (ahead.index != request.index) ahead = read(in, request.index);
    parent.putAll(ahead.trouble);
    if (ahead.trouble.empty()) putFrame(parent, ahead.frame);
    const std::size_t next = request.index + (last == noFrame ? 1 : request.index - last);
    if (next != ahead.index && next < in.constants().times.size()) ahead = read(in, next);
    last = request.index;
  }
}

/// All that the child does.
void serve(Channel& parent, const std::filesystem::path& file) {
  ChildProcess::allow(patience(file));
  std::optional<Hdf5Input> in;
  SceneText text;
  std::string trouble = troubleOf([&] { text = readSceneText(in.emplace(file)); });
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
  answer(parent, *trajectory, file);
}

}  // namespace

ReaderProcess::ReaderProcess(std::filesystem::path file)
    : file_(std::move(file)), child_([this](Channel& parent) { serve(parent, file_); }) {}

std::optional<Diagnostic> ReaderProcess::trouble() {
  std::string text = child_.channel().getAll<std::string>();
  if (text.empty()) return std::nullopt;
  return fileTrouble(file_, std::move(text));
}

Result<RecordedRun> ReaderProcess::open() {
  if (auto problem = trouble()) return *problem;
  SceneText text;
  text.text = child_.channel().getAll<std::string>();
  text.name = child_.channel().getAll<std::string>();
  Result<Scene> scene = parse(text, file_);
  if (!scene) return std::move(scene.problems);
  if (auto problem = trouble()) return *problem;
  return RecordedRun{std::move(*scene), getConstants(child_.channel())};
}

Result<FramePtr> ReaderProcess::frame(const RecordedRun& run, std::size_t index) {
  child_.channel().put(Request{Wanted::frame, index});
  if (auto problem = trouble()) return *problem;
  return getFrame(child_.channel(), run, index);
}

std::vector<std::byte> ReaderProcess::checkpoint(std::size_t slot) {
  child_.channel().put(Request{Wanted::checkpoint, slot});
  return child_.channel().getAll<std::vector<std::byte>>();
}

}  // namespace bedmix
