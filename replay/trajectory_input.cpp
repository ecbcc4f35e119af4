// SPDX-License-Identifier: MIT
#include "replay/trajectory_input.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "replay/trajectory_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace bedmix {

namespace {

std::string valueOf(const char* element) { return element + std::string("/value"); }

/// Without a branch each, as almost always all are.
bool areFinite(const float* from, const float* end) {
  constexpr std::uint32_t magnitude = 0x7fffffff, infinity = 0x7f800000;
  std::uint32_t largest = 0;
  for (; from != end; ++from) largest = std::max(largest, std::bit_cast<std::uint32_t>(*from) & magnitude);
  return largest < infinity;
}

/// Reads row `index` of a series of floats, all of them finite, and returns its end.
float* readFloats(const Hdf5Values& series, std::size_t index, float* into) {
  series.readRow(index, into);
  float* const end = into + series.rowSize();
  if (areFinite(into, end)) return end;
  float* const bad = std::find_if(into, end, [](float v) { return !std::isfinite(v); });
  throw Hdf5Error(fmt::format("frame {} holds {} in {}, place {}; what comes before it can be used", index,
                              *bad, series.path(), bad - into));
}

Provenance readProvenance(const Hdf5Input& in) {
  try {
    return {in.text(layout::version), in.text(layout::commit)};
  } catch (const Hdf5Error&) {
    return {};
  }
}

/// Lost bytes are no number, and no text.
bool isWhole(const RunEvent& event) {
  constexpr char lost = '\xff';
  return std::isfinite(event.time) && (event.kind + event.detail).find(lost) == std::string::npos;
}

/// Those that are there as a whole.
std::vector<RunEvent> readEvents(const Hdf5Input& in) {
  try {
    const std::vector<std::string> kinds = in.texts(layout::eventKind),
                                   details = in.texts(layout::eventDetail);
    const Hdf5Values times = in.series(layout::eventTime, {});
    std::vector<RunEvent> events(std::min({kinds.size(), details.size(), std::size_t{times.rows()}}));
    for (std::size_t i = 0; i < events.size(); ++i) {
      events[i] = {0.0, kinds[i], details[i]};
      times.readRow(i, &events[i].time);
      if (!isWhole(events[i])) return {events.begin(), events.begin() + static_cast<std::ptrdiff_t>(i)};
    }
    return events;
  } catch (const Hdf5Error&) {
    return {};
  }
}

}  // namespace

SceneText readSceneText(const Hdf5Input& in) {
  if (!in.has("h5md")) throw Hdf5Error("is HDF5 but not H5MD: it has no group h5md");
  const std::vector<std::int32_t> version = in.integers("h5md", "version");
  if (version.size() != 2 || version[0] != 1)
    throw Hdf5Error("is of H5MD version " + (version.empty() ? "?" : std::to_string(version[0])) +
                    "; this bedmix reads version 1");
  if (!in.has(layout::scene))
    throw Hdf5Error("is H5MD but no run of bedmix: it has no " + std::string(layout::scene));
  return {in.text(layout::scene), in.text(layout::sceneName)};
}

std::size_t numbersPerFrame(const Scene& scene) {
  const auto particles = static_cast<std::size_t>(mostParticles(scene));
  const bool heat = scene.effects.find<HeatSettings>() != nullptr;
  const std::size_t fed = scene.effects.find<FeedSettings>() ? (isMixed(scene) ? 4 : 2) : 0;
  const std::size_t reaction = scene.effects.find<ReactionSettings>() ? 1 : 0;
  const std::size_t ofParticles =
      particles * (4 + (scene.contacts.friction ? 1 : 0) + (heat ? 1 : 0) + reaction + fed);
  if (!scene.gas) return ofParticles;
  const GasGrid grid = makeGasGrid(scene);
  return ofParticles +
         (heat ? 5 : 4) * static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
}

TrajectoryInput::TrajectoryInput(const Hdf5Input& in, const Scene& scene)
    : in_(in),
      particles_(static_cast<hsize_t>(mostParticles(scene))),
      position_(in.series(valueOf(layout::position), {particles_, 2})),
      velocity_(in.series(valueOf(layout::velocity), {particles_, 2})),
      kinds_(particleKinds(scene).size()) {
  if (scene.contacts.friction)
    angularVelocity_.emplace(in.series(valueOf(layout::angularVelocity), {particles_}));
  if (scene.effects.find<HeatSettings>())
    temperature_.emplace(in.series(valueOf(layout::temperature), {particles_}));
  if (scene.effects.find<ReactionSettings>())
    content_.emplace(in.series(valueOf(layout::content), {particles_}));
  if (scene.effects.find<FeedSettings>()) fed_.emplace(openFed(in, scene));
  if (scene.gas) gas_.emplace(openGas(in, scene));
  readTimes();
  if (!fed_) readSpecies();
  if (!fed_ && isMixed(scene)) readKinds();
  constants_.provenance = readProvenance(in);
  constants_.events = readEvents(in);
}

TrajectoryInput::GasSeries TrajectoryInput::openGas(const Hdf5Input& in, const Scene& scene) {
  const GasGrid grid = makeGasGrid(scene);
  const auto rows = static_cast<hsize_t>(grid.rows), columns = static_cast<hsize_t>(grid.columns);
  GasSeries series{in.series(valueOf(layout::voidage), {rows, columns}),
                   in.series(valueOf(layout::pressure), {rows, columns}),
                   in.series(valueOf(layout::gasVelocity), {rows, columns, 2}),
                   {}};
  if (scene.effects.find<HeatSettings>())
    series.temperature.emplace(in.series(valueOf(layout::gasTemperature), {rows, columns}));
  return series;
}

TrajectoryInput::FedSeries TrajectoryInput::openFed(const Hdf5Input& in, const Scene& scene) {
  const auto n = static_cast<hsize_t>(mostParticles(scene));
  FedSeries series{in.series(valueOf(layout::id), {n}), in.series(valueOf(layout::species), {n}), {}, {}};
  if (!isMixed(scene)) return series;
  series.radius.emplace(in.series(valueOf(layout::radius), {n}));
  series.kind.emplace(in.series(valueOf(layout::kind), {n}));
  return series;
}

void TrajectoryInput::readTimes() {
  const Hdf5Values step = in_.series(layout::position + std::string("/step"), {});
  const Hdf5Values time = in_.series(layout::position + std::string("/time"), {});
  hsize_t frames = std::min({step.rows(), time.rows(), position_.rows(), velocity_.rows()});
  for (const auto* series : {&angularVelocity_, &temperature_, &content_})
    if (*series) frames = std::min(frames, (*series)->rows());
  if (fed_) frames = std::min({frames, fed_->id.rows(), fed_->species.rows()});
  if (fed_ && fed_->kind) frames = std::min({frames, fed_->radius->rows(), fed_->kind->rows()});
  if (gas_) frames = std::min({frames, gas_->voidage.rows(), gas_->pressure.rows(), gas_->velocity.rows()});
  if (gas_ && gas_->temperature) frames = std::min(frames, gas_->temperature->rows());
  if (frames == 0) throw Hdf5Error("holds no whole frame: its run ended before the first was written");
  constants_.recorded = frames;
  std::vector<std::int64_t>& steps = constants_.steps;
  std::vector<double>& times = constants_.times;
  steps.resize(frames);
  times.resize(frames);
  const bool isWhole = in_.reading() == Reading::whole;
  if (isWhole) {
    step.readRows(frames, steps.data());
    time.readRows(frames, times.data());
  }
  for (std::size_t i = 0; i < frames; ++i) {
    try {
      if (!isWhole) {
        step.readRow(i, &steps[i]);
        time.readRow(i, &times[i]);
      }
      expectToFollow(i);
    } catch (const Hdf5Error&) {
      if (isWhole || i == 0) throw;
      frames = i;
      steps.resize(frames);
      times.resize(frames);
    }
  }
}

void TrajectoryInput::expectToFollow(std::size_t i) const {
  const std::vector<std::int64_t>& steps = constants_.steps;
  const std::vector<double>& times = constants_.times;
  if (!std::isfinite(times[i]))
    throw Hdf5Error(fmt::format("the time of frame {} is {}, no number", i, times[i]));
  if (i > 0 && !(times[i] > times[i - 1] && steps[i] > steps[i - 1]))
    throw Hdf5Error(fmt::format("frame {} at {} s, step {} does not follow frame {} at {} s, step {}", i,
                                times[i], steps[i], i - 1, times[i - 1], steps[i - 1]));
}

void TrajectoryInput::readSpecies() {
  std::vector<std::uint8_t>& species = constants_.species;
  std::vector<std::int32_t>& id = constants_.id;
  species.resize(particles_);
  id.resize(particles_);
  in_.fixed(layout::species, {particles_}).readRow(0, species.data());
  in_.fixed(layout::id, {particles_}).readRow(0, id.data());
  const auto other = std::find_if(species.begin(), species.end(), [](std::uint8_t s) { return s > 1; });
  if (other != species.end())
    throw Hdf5Error(fmt::format("particle {} is of species {}; only 0 and 1 (tracer) are known",
                                other - species.begin(), *other));
}

void TrajectoryInput::readKinds() {
  std::vector<float>& radius = constants_.radius;
  std::vector<std::uint8_t>& kind = constants_.kind;
  radius.resize(particles_);
  kind.resize(particles_);
  in_.fixed(layout::radius, {particles_}).readRow(0, radius.data());
  in_.fixed(layout::kind, {particles_}).readRow(0, kind.data());
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (!(std::isfinite(radius[i]) && radius[i] > 0.0f))
      throw Hdf5Error(fmt::format("particle {} has a radius of {} m", i, radius[i]));
    if (kind[i] >= kinds_)
      throw Hdf5Error(fmt::format("particle {} is of kind {}; the scene has {}", i, kind[i], kinds_));
  }
}

void TrajectoryInput::readFrame(std::size_t index, float* into) const {
  into = readFloats(position_, index, into);
  into = readFloats(velocity_, index, into);
  for (const auto* series : {&angularVelocity_, &temperature_, &content_})
    if (*series) into = readFloats(**series, index, into);
  if (fed_) into = readFed(index, into);
  if (!gas_) return;
  for (const Hdf5Values* field : {&gas_->voidage, &gas_->pressure, &gas_->velocity})
    into = readFloats(*field, index, into);
  if (gas_->temperature) readFloats(*gas_->temperature, index, into);
}

float* TrajectoryInput::readFed(std::size_t index, float* into) const {
  const auto refuse = [&](std::size_t place, const auto& what) {
    throw Hdf5Error(fmt::format("frame {} holds {} at place {} of its particles", index, what, place));
  };
  std::vector<std::int32_t> id(particles_);
  fed_->id.readRow(index, id.data());
  std::size_t there = 0;
  while (there < id.size() && id[there] >= 0) ++there;
  for (std::size_t i = 0; i < id.size(); ++i)
    if (i < there ? i > 0 && id[i] <= id[i - 1] : id[i] != -1) refuse(i, fmt::format("the id {}", id[i]));
  std::memcpy(into, id.data(), id.size() * sizeof(float));
  into += particles_;

  const auto read = [&](const Hdf5Values& series, const char* what, auto&& isSound) {
    float* const end = readFloats(series, index, into);
    for (std::size_t i = 0; i < there; ++i)
      if (!isSound(into[i])) refuse(i, fmt::format("the {} {}", what, into[i]));
    into = end;
  };
  read(fed_->species, "species", [](float s) { return s <= 1.0f; });
  if (!fed_->kind) return into;
  read(*fed_->radius, "radius", [](float r) { return r > 0.0f; });
  read(*fed_->kind, "kind", [&](float k) { return k < static_cast<float>(kinds_); });
  return into;
}

std::vector<std::byte> TrajectoryInput::checkpoint(std::size_t slot) const {
  const char* const path = layout::checkpointSlots[slot];
  try {
    if (!in_.has(path)) return {};
    const Hdf5Values values = in_.series(path, {});
    std::vector<std::byte> bytes(values.rows());
    if (!bytes.empty()) values.readRows(bytes.size(), reinterpret_cast<std::uint8_t*>(bytes.data()));
    return bytes;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace bedmix
