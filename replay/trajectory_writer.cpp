// SPDX-License-Identifier: MIT
#include "replay/trajectory_writer.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/mixing.h"
#include "engine/core/particle_list.h"
#include "engine/core/scene_reader.h"
#include "replay/child_process.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/hdf5_output.h"
#include "replay/trajectory_layout.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <stdexcept>

namespace bedmix {

namespace {

using Bytes = std::span<const std::byte>;

template <class T>
Bytes bytes(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}
template <class T>
Bytes bytes(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

/// Made `size` bytes long: with zeros, or cut before the character that goes beyond.
std::vector<char> padded(const std::string& text, std::size_t size) {
  std::size_t end = std::min(text.size(), size);
  if (end < text.size())
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  std::vector<char> row(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end));
  row.resize(size);
  return row;
}

/// What the file holds beside the frames themselves; NaN where undefined.
struct Observables {
  double lacey, ashton, stddev, flux, pressureDrop, bedHeight;
};

double orNan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// All that does not change with time, beside the particles' own constants.
void writeHeader(const Hdf5Output& out, const Scene& scene, const Provenance& provenance) {
  constexpr std::int32_t h5mdVersion[] = {1, 1};
  constexpr std::int32_t dimension[] = {2};
  for (const char* group :
       {"h5md", "h5md/author", "h5md/creator", "parameters", "particles", layout::particles, layout::box,
        "observables", layout::bedmix, layout::checkpoint, layout::events})
    out.group(group);
  out.attribute("h5md", "version", h5mdVersion);
  out.attribute("h5md/author", "name", {"bedmix"});
  out.attribute("h5md/creator", "name", {"bedmix"});
  out.attribute("h5md/creator", "version", {provenance.version});

  out.text(layout::scene, writeScene(scene));
  out.text(layout::sceneName, scene.name);
  out.text(layout::version, provenance.version);
  out.text(layout::commit, provenance.commit);
  out.number("parameters/seed", scene.seed);

  out.attribute(layout::box, "dimension", dimension);
  out.attribute(layout::box, "boundary",
                {scene.bed.sides == BedSides::periodic ? "periodic" : "none", "none"});
  out.fixed<double>(layout::box + std::string("/edges"), std::array{scene.bed.width, scene.bed.height});
}

void writeGasGrid(const Hdf5Output& out, const GasGrid& grid) {
  out.group(layout::gas);
  out.fixed<double>(layout::gasX, grid.x);
  out.fixed<double>(layout::gasY, grid.y);
  out.fixed<std::int32_t>(layout::gas + std::string("/lowest_row"), grid.lowestRow);
}

/// What has happened to the run; an event counts once all three know it.
struct EventLog {
  TimeSeries time, kind, detail;

  explicit EventLog(const Hdf5Output& out)
      : time(out.series<double>(layout::eventTime, {})),
        kind(out.texts(layout::eventKind, layout::eventKindSize)),
        detail(out.texts(layout::eventDetail, layout::eventDetailSize)) {}

  void append(const RunEvent& event) {
    const hsize_t index = std::min({time.rows(), kind.rows(), detail.rows()});
    kind.append(index, bytes(padded(event.kind, layout::eventKindSize)));
    detail.append(index, bytes(padded(event.detail, layout::eventDetailSize)));
    time.append(index, bytes(event.time));
  }
};

/// One time-dependent element, and where a frame has its row.
struct Element {
  TimeSeries value;
  std::function<Bytes(const Frame&)> row;
};

}  // namespace

struct TrajectoryWriter::State {
  std::filesystem::path path;
  Scene scene;
  SamplingGrid sampling;
  bool isFed;
  std::optional<GasGrid> grid;
  Hdf5Output out;
  Origin origin;
  std::optional<TimeSeries> step, time;  // of all elements
  std::vector<Element> elements;         // positions first
  std::vector<ByteStore> checkpoints;
  std::size_t nextCheckpoint = 0;
  std::optional<EventLog> events;
  Observables seen{};
  std::vector<std::uint8_t> species;
  std::vector<std::int32_t> id;
  hsize_t frames = 0, found = 0;  // accepted, and there; the latter may be more where a run is resumed

  /// The provenance is needed where the file is made.
  State(const std::filesystem::path& file, const Scene& s, Origin from, const Provenance& provenance = {})
      : path(file),
        scene(s),
        sampling(samplingGrid(s)),
        isFed(s.effects.find<FeedSettings>() != nullptr),
        out(file, from),
        origin(from) {
    if (scene.gas) grid = makeGasGrid(scene);
    if (origin == Origin::made) {
      writeHeader(out, scene, provenance);
      if (grid) writeGasGrid(out, *grid);
    } else {
      out.replaceText(layout::scene, writeScene(scene));
    }
    events.emplace(out);
    addParticles();
    addObservables();
    if (grid) addGas();
    addCheckpoints();
  }

  template <class T>
  void add(const std::string& name, std::vector<hsize_t> extent, std::function<Bytes(const Frame&)> row) {
    if (origin == Origin::made) out.group(name);
    if (elements.empty()) {
      step = out.series<std::int64_t>(name + "/step", {});
      time = out.series<double>(name + "/time", {});
    } else if (origin == Origin::made) {
      out.link(layout::position + std::string("/step"), name + "/step");
      out.link(layout::position + std::string("/time"), name + "/time");
    }
    elements.push_back({out.series<T>(name + "/value", std::move(extent)), std::move(row)});
  }

  void addParticles() {
    const auto n = static_cast<hsize_t>(mostParticles(scene));
    add<float>(layout::position, {n, 2}, rowsOf(&Frame::position));
    add<float>(layout::velocity, {n, 2}, rowsOf(&Frame::velocity));
    if (scene.contacts.friction) add<float>(layout::angularVelocity, {n}, rowsOf(&Frame::angularVelocity));
    if (scene.effects.find<HeatSettings>()) add<float>(layout::temperature, {n}, rowsOf(&Frame::temperature));
    if (scene.effects.find<ReactionSettings>()) add<float>(layout::content, {n}, rowsOf(&Frame::content));
    if (!isFed) return;
    add<std::int32_t>(layout::id, {n}, rowsOf(&Frame::id, -1));
    add<std::uint8_t>(layout::species, {n}, rowsOf(&Frame::species));
    if (!isMixed(scene)) return;
    add<float>(layout::radius, {n}, rowsOf(&Frame::radius));
    add<std::uint8_t>(layout::kind, {n}, rowsOf(&Frame::kind));
  }

  /// A column of frames; with a feed filled up with `absent` for those who are not there.
  template <class T>
  std::function<Bytes(const Frame&)> rowsOf(std::vector<T> Frame::*column, T absent = T()) const {
    if (!isFed) return [column](const Frame& f) { return bytes(f.*column); };
    return [column, absent,
            row = std::vector<T>(static_cast<std::size_t>(mostParticles(scene)))](const Frame& f) mutable {
      const std::vector<T>& there = f.*column;
      if (there.size() > row.size())
        throw Hdf5Error("cannot write step " + std::to_string(f.step) + ": it has more particles than " +
                        std::to_string(row.size()));
      std::fill(std::copy(there.begin(), there.end(), row.begin()), row.end(), absent);
      return bytes(row);
    };
  }

  void addObservables() {
    const auto observe = [this](const std::string& name, const double& value) {
      add<double>("observables/" + name, {}, [&value](const Frame&) { return bytes(value); });
    };
    observe("lacey", seen.lacey);
    observe("ashton", seen.ashton);
    observe("stddev", seen.stddev);
    if (scene.flux) observe("flux", seen.flux);
    if (grid) observe("pressure_drop", seen.pressureDrop);
    observe("bed_height", seen.bedHeight);
  }

  void addGas() {
    const auto rows = static_cast<hsize_t>(grid->rows), columns = static_cast<hsize_t>(grid->columns);
    add<float>(layout::voidage, {rows, columns}, [](const Frame& f) { return bytes(f.gas.voidage); });
    add<float>(layout::pressure, {rows, columns}, [](const Frame& f) { return bytes(f.gas.pressure); });
    add<float>(layout::gasVelocity, {rows, columns, 2}, [](const Frame& f) { return bytes(f.gas.velocity); });
    if (scene.effects.find<HeatSettings>())
      add<float>(layout::gasTemperature, {rows, columns},
                 [](const Frame& f) { return bytes(f.gas.temperature); });
  }

  void addCheckpoints() {
    // A few chunks each: they take room as a whole, and each costs time.
    constexpr hsize_t page = 4096, largest = 1 << 20, perParticle = 100;
    const hsize_t some = perParticle * static_cast<hsize_t>(mostParticles(scene)) / page * page;
    for (const char* slot : layout::checkpointSlots)
      checkpoints.push_back(out.bytes(slot, std::clamp(some, page, largest)));
  }

  /// Takes out what comes after the first `count` frames. Positions go first: then what is left of the others
  /// belongs to no frame, and may go in any order.
  void cut(hsize_t count) {
    elements.front().value.cut(count);
    out.flush();
    for (Element& e : elements) e.value.cut(count);
    time->cut(count);
    step->cut(count);
    out.flush();
    found = count;
  }

  /// Goes on after the first `count` frames.
  void resume(hsize_t count, std::size_t sound) {
    found = std::min(step->rows(), time->rows());
    for (const Element& e : elements) found = std::min(found, e.value.rows());
    frames = count;
    nextCheckpoint = 1 - sound;
  }

  /// Reads all that may be compared or cut, and writes once where the run will write.
  void rehearse() {
    for (hsize_t i = frames; i < found; ++i) {
      for (const Element& e : elements) e.value.holds(i, {});
      time->holds(i, {});
      step->holds(i, {});
    }
    cut(frames);
    const auto append = [this](TimeSeries& series) {
      const std::vector<std::byte> nothing(series.rowBytes());
      for (const hsize_t row : {frames, frames + 1}) series.append(row, nothing);
    };
    for (Element& e : elements) append(e.value);
    append(*time);
    append(*step);
    for (ByteStore& checkpoint : checkpoints) checkpoint.write(std::array<std::byte, 1>{});
    events->append({});
    out.flush();
  }

  bool isThere(const Frame& frame) const {
    return step->holds(frames, bytes(frame.step)) && time->holds(frames, bytes(frame.time)) &&
           std::all_of(elements.begin(), elements.end(),
                       [&](const Element& e) { return e.value.holds(frames, e.row(frame)); });
  }

  void keep(std::span<const std::byte> checkpoint) {
    checkpoints[nextCheckpoint].write(checkpoint);
    out.flush();
    nextCheckpoint = 1 - nextCheckpoint;
  }

  /// What particles are is written once, so they must not change, but where they come and go.
  void writeConstants(const Frame& frame) {
    if (isFed) return;
    if (species.empty()) {
      species = frame.species;
      id = frame.id;
    }
    if (frames == 0) {
      out.fixed<std::uint8_t>(layout::species, species);
      out.fixed<std::int32_t>(layout::id, id);
      if (isMixed(scene)) {
        out.fixed<float>(layout::radius, frame.radius);
        out.fixed<std::uint8_t>(layout::kind, frame.kind);
      }
    }
    if (frame.species != species || frame.id != id)
      throw Hdf5Error("cannot write step " + std::to_string(frame.step) +
                      ": particles changed their ids or species during the run");
  }

  void observe(const Frame& frame) {
    const MixingSample mixing = mixingSample(frame, sampling);
    seen.lacey = orNan(mixing.lacey);
    seen.ashton = orNan(mixing.ashton);
    seen.stddev = orNan(mixing.stddev);
    if (scene.flux) seen.flux = solidsFlux(frame, scene);
    if (grid) seen.pressureDrop = pressureDrop(frame, *grid);
    seen.bedHeight = bedHeight(frame, scene);
  }

  void write(const Frame& frame) {
    writeConstants(frame);
    observe(frame);
    if (frames < found) {
      if (isThere(frame)) {
        ++frames;
        return;
      }
      cut(frames);
    }
    for (Element& e : elements) e.value.append(frames, e.row(frame));
    time->append(frames, bytes(frame.time));
    step->append(frames, bytes(frame.step));
    out.flush();
    found = ++frames;
  }
};

Result<TrajectoryWriter> TrajectoryWriter::create(const std::filesystem::path& path, const Scene& scene,
                                                  const Provenance& provenance) {
  try {
    return TrajectoryWriter(std::make_unique<State>(path, scene, Origin::made, provenance));
  } catch (const Hdf5Error& e) {
    return fileTrouble(path, e.what());
  }
}

void TrajectoryWriter::rehearseResume(const std::filesystem::path& path, const Scene& scene,
                                      std::size_t frames, std::size_t sound) {
  ChildProcess child([&](Channel& parent) {
    allowWorkOn(path);
    parent.putAll(troubleOf([&] {
      State state(path, scene, Origin::rehearsed);
      state.resume(frames, sound);
      state.rehearse();
    }));
  });
  try {
    const auto trouble = child.channel().getAll<std::string>();
    if (!trouble.empty()) throw Hdf5Error(trouble);
  } catch (const ChannelClosed&) {
    throw Hdf5Error(damageShownBy(child.end()));
  }
}

Result<TrajectoryWriter> TrajectoryWriter::resume(const std::filesystem::path& path, const Scene& scene,
                                                  std::size_t frames, std::size_t sound) {
  try {
    rehearseResume(path, scene, frames, sound);
    auto state = std::make_unique<State>(path, scene, Origin::found);
    state->resume(frames, sound);
    return TrajectoryWriter(std::move(state));
  } catch (const std::runtime_error& e) {
    return fileTrouble(path, e.what());
  }
}

TrajectoryWriter::TrajectoryWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
TrajectoryWriter::~TrajectoryWriter() = default;
TrajectoryWriter::TrajectoryWriter(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter& TrajectoryWriter::operator=(TrajectoryWriter&&) noexcept = default;

std::optional<Diagnostic> TrajectoryWriter::write(const Frame& frame) {
  return attempt([&](State& state) { state.write(frame); });
}

template <class Action>
std::optional<Diagnostic> TrajectoryWriter::attempt(Action&& action) {
  try {
    action(*state_);
    return std::nullopt;
  } catch (const Hdf5Error& e) {
    return fileTrouble(state_->path, e.what());
  }
}

void TrajectoryWriter::keep(std::span<const std::byte> checkpoint) {
  unlessFailed([&] { return attempt([&](State& state) { state.keep(checkpoint); }); });
}

void TrajectoryWriter::note(const RunEvent& event) {
  unlessFailed([&] {
    return attempt([&](State& state) {
      state.events->append(event);
      state.out.flush();
    });
  });
}

void TrajectoryWriter::finish() {
  unlessFailed([&] {
    return attempt([](State& state) {
      if (state.frames < state.found) state.cut(state.frames);
    });
  });
}

std::string hdf5Version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return "HDF5 " + std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(release);
}

}  // namespace bedmix
