// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"

#include "engine/core/gas_grid.h"
#include "engine/core/scene_reader.h"
#include "replay/file_trouble.h"
#include "replay/hdf5_input.h"
#include "replay/trajectory_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace bedmix {

namespace {

/// A scene inside a file that cannot be read, each problem under the file's name.
struct SceneError {
  std::vector<Diagnostic> problems;
};

std::string valueOf(const char* element) { return element + std::string("/value"); }

void checkVersion(const Hdf5Input& in) {
  if (!in.has("h5md")) throw Hdf5Error("is HDF5 but not H5MD: it has no group h5md");
  const std::vector<std::int32_t> version = in.integers("h5md", "version");
  if (version.size() != 2 || version[0] != 1)
    throw Hdf5Error("is of H5MD version " + (version.empty() ? "?" : std::to_string(version[0])) +
                    "; this bedmix reads version 1");
}

Scene readRecordedScene(const Hdf5Input& in, const std::filesystem::path& path) {
  checkVersion(in);
  if (!in.has(layout::scene))
    throw Hdf5Error("is H5MD but no run of bedmix: it has no " + std::string(layout::scene));
  Result<Scene> scene = readScene(in.text(layout::scene), path.string() + ':' + layout::scene);
  if (!scene) {
    for (Diagnostic& problem : scene.problems) problem.trouble = Trouble::file;
    throw SceneError{std::move(scene.problems)};
  }
  scene->name = in.text(layout::sceneName);
  return *scene;
}

/// Row `index` of a series of floats, all of them finite.
template <class T>
std::vector<T> readFloats(const Hdf5Values& series, std::size_t index) {
  std::vector<T> row(series.rowSize() * sizeof(float) / sizeof(T));
  float* const numbers = reinterpret_cast<float*>(row.data());
  series.readRow(index, numbers);
  const auto isBad = [](float v) { return !std::isfinite(v); };
  const auto at = std::find_if(numbers, numbers + series.rowSize(), isBad) - numbers;
  if (at < static_cast<std::ptrdiff_t>(series.rowSize()))
    throw Hdf5Error(fmt::format("frame {} holds {} in {}, place {}; what comes before it can be used", index,
                                numbers[at], series.path(), at));
  return row;
}

/// The gas fields of the frames.
struct GasSeries {
  Hdf5Values voidage, pressure, velocity;
};

GasSeries openGas(const Hdf5Input& in, const Scene& scene) {
  const GasGrid grid = makeGasGrid(scene);
  const auto rows = static_cast<hsize_t>(grid.rows), columns = static_cast<hsize_t>(grid.columns);
  return {in.series(valueOf(layout::voidage), {rows, columns}),
          in.series(valueOf(layout::pressure), {rows, columns}),
          in.series(valueOf(layout::gasVelocity), {rows, columns, 2})};
}

}  // namespace

struct TrajectoryReader::State {
  std::filesystem::path path;
  Hdf5Input in;
  Scene scene;
  hsize_t particles;
  Hdf5Values position, velocity;
  std::optional<Hdf5Values> angularVelocity;
  std::optional<GasSeries> gas;
  std::vector<std::uint8_t> species;
  std::vector<std::int32_t> id;
  std::vector<std::int64_t> steps;
  std::vector<double> times;
  std::size_t nextFrame = 0;
  std::optional<Diagnostic> failure;

  explicit State(const std::filesystem::path& file)
      : path(file),
        in(file),
        scene(readRecordedScene(in, file)),
        particles(static_cast<hsize_t>(scene.particles.count)),
        position(in.series(valueOf(layout::position), {particles, 2})),
        velocity(in.series(valueOf(layout::velocity), {particles, 2})) {
    if (scene.contacts.friction)
      angularVelocity.emplace(in.series(valueOf(layout::angularVelocity), {particles}));
    if (scene.gas) gas.emplace(openGas(in, scene));
    readTimes();
    readConstants();
  }

  void readTimes() {
    const Hdf5Values step = in.series(layout::position + std::string("/step"), {});
    const Hdf5Values time = in.series(layout::position + std::string("/time"), {});
    hsize_t frames = std::min({step.rows(), time.rows(), position.rows(), velocity.rows()});
    if (angularVelocity) frames = std::min(frames, angularVelocity->rows());
    if (gas) frames = std::min({frames, gas->voidage.rows(), gas->pressure.rows(), gas->velocity.rows()});
    if (frames == 0) throw Hdf5Error("holds no whole frame: its run ended before the first was written");
    steps.resize(frames);
    times.resize(frames);
    step.readRows(frames, steps.data());
    time.readRows(frames, times.data());
    for (std::size_t i = 0; i < frames; ++i) {
      if (!std::isfinite(times[i]))
        throw Hdf5Error(fmt::format("the time of frame {} is {}, no number", i, times[i]));
      if (i > 0 && !(times[i] > times[i - 1] && steps[i] > steps[i - 1]))
        throw Hdf5Error(fmt::format("frame {} at {} s, step {} does not follow frame {} at {} s, step {}", i,
                                    times[i], steps[i], i - 1, times[i - 1], steps[i - 1]));
    }
  }

  void readConstants() {
    species.resize(particles);
    id.resize(particles);
    in.fixed(layout::species, {particles}).readRow(0, species.data());
    in.fixed(layout::id, {particles}).readRow(0, id.data());
    const auto other = std::find_if(species.begin(), species.end(), [](std::uint8_t s) { return s > 1; });
    if (other != species.end())
      throw Hdf5Error(fmt::format("particle {} is of species {}; only 0 and 1 (tracer) are known",
                                  other - species.begin(), *other));
  }

  FramePtr read(std::size_t index) const {
    auto frame = std::make_shared<Frame>();
    frame->step = steps[index];
    frame->time = times[index];
    frame->position = readFloats<Vec2f>(position, index);
    frame->velocity = readFloats<Vec2f>(velocity, index);
    if (angularVelocity) frame->angularVelocity = readFloats<float>(*angularVelocity, index);
    frame->species = species;
    frame->id = id;
    if (gas) {
      frame->gas.voidage = readFloats<float>(gas->voidage, index);
      frame->gas.pressure = readFloats<float>(gas->pressure, index);
      frame->gas.velocity = readFloats<Vec2f>(gas->velocity, index);
    }
    return frame;
  }
};

Result<TrajectoryReader> TrajectoryReader::open(const std::filesystem::path& path) {
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(path, error);
  const std::filesystem::path file = isFolder ? path / layout::fileName : path;
  if (!std::filesystem::exists(file, error))
    return fileTrouble(file, "does not exist; name a trajectory.h5 or the folder of a run");
  try {
    return TrajectoryReader(std::make_unique<State>(file));
  } catch (const SceneError& e) {
    return e.problems;
  } catch (const std::exception& e) {
    return fileTrouble(file, e.what());
  }
}

TrajectoryReader::TrajectoryReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
TrajectoryReader::~TrajectoryReader() = default;
TrajectoryReader::TrajectoryReader(TrajectoryReader&&) noexcept = default;
TrajectoryReader& TrajectoryReader::operator=(TrajectoryReader&&) noexcept = default;

const Scene& TrajectoryReader::scene() const { return state_->scene; }
Provenance TrajectoryReader::provenance() const {
  try {
    return {state_->in.text(layout::version), state_->in.text(layout::commit)};
  } catch (const Hdf5Error&) {
    return {};
  }
}
const std::vector<double>& TrajectoryReader::times() const { return state_->times; }
const std::optional<Diagnostic>& TrajectoryReader::failure() const { return state_->failure; }

Result<FramePtr> TrajectoryReader::frame(std::size_t index) {
  try {
    return state_->read(index);
  } catch (const std::exception& e) {
    return fileTrouble(state_->path, e.what());
  }
}

std::vector<std::vector<std::byte>> TrajectoryReader::checkpoints() const {
  std::vector<std::vector<std::byte>> found;
  for (const char* slot : layout::checkpointSlots) {
    std::vector<std::byte>& bytes = found.emplace_back();
    if (!state_->in.has(slot)) continue;
    try {
      const Hdf5Values values = state_->in.series(slot, {});
      // No more than the file can hold, whatever it says.
      bytes.resize(std::min<std::uintmax_t>(values.rows(), std::filesystem::file_size(state_->path)));
      if (!bytes.empty()) values.readRows(bytes.size(), reinterpret_cast<std::uint8_t*>(bytes.data()));
    } catch (const std::exception&) {
      bytes.clear();
    }
  }
  return found;
}

FramePtr TrajectoryReader::next() {
  if (state_->failure || state_->nextFrame == state_->times.size()) return nullptr;
  Result<FramePtr> read = frame(state_->nextFrame++);
  if (read) return *read;
  state_->failure = read.problems.front();
  return nullptr;
}

}  // namespace bedmix
