// SPDX-License-Identifier: MIT
#include "replay/series_log.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/particle_list.h"

#include <algorithm>

namespace bedmix {

Result<MixingLog> MixingLog::create(const std::filesystem::path& path, const SamplingGrid& grid) {
  Result<CsvWriter> csv = CsvWriter::create(
      path, "time,lacey,ashton,stddev,tracer_mean,cells,particles_per_cell,counted_fraction");
  if (!csv) return csv.problems;
  return MixingLog(std::move(*csv), grid);
}

std::optional<Diagnostic> MixingLog::write(const Frame& frame) {
  const MixingSample s = mixingSample(frame, grid_);
  return csv_.row(
      {s.time, s.lacey, s.ashton, s.stddev, s.tracerMean, s.cells, s.particlesPerCell, s.countedFraction});
}

Result<FluxLog> FluxLog::create(const std::filesystem::path& path, const Scene& scene) {
  Result<CsvWriter> csv = CsvWriter::create(path, "time,flux");
  if (!csv) return csv.problems;
  return FluxLog(std::move(*csv), scene);
}

std::optional<Diagnostic> FluxLog::write(const Frame& frame) {
  return csv_.row({frame.time, solidsFlux(frame, scene_)});
}

Result<PressureLog> PressureLog::create(const std::filesystem::path& path, const Scene& scene) {
  Result<CsvWriter> csv = CsvWriter::create(path, "time,pressure_drop,bed_height");
  if (!csv) return csv.problems;
  return PressureLog(std::move(*csv), scene);
}

std::optional<Diagnostic> PressureLog::write(const Frame& frame) {
  return csv_.row({frame.time, pressureDrop(frame, grid_), bedHeight(frame, scene_)});
}

Result<HeatLog> HeatLog::create(const std::filesystem::path& path, const Scene& scene) {
  Result<CsvWriter> csv =
      CsvWriter::create(path, "time,particle_temperature,outlet_temperature,particle_heat");
  if (!csv) return csv.problems;
  return HeatLog(std::move(*csv), scene);
}

std::optional<Diagnostic> HeatLog::write(const Frame& frame) {
  std::optional<double> outlet;
  if (grid_) outlet = outletTemperature(frame, *grid_);
  return csv_.row({frame.time, meanTemperature(frame, scene_), outlet, particleHeat(frame, scene_)});
}

Result<ReactionLog> ReactionLog::create(const std::filesystem::path& path, const Scene& scene) {
  Result<CsvWriter> csv = CsvWriter::create(path, "time,content");
  if (!csv) return csv.problems;
  return ReactionLog(std::move(*csv), scene);
}

std::optional<Diagnostic> ReactionLog::write(const Frame& frame) {
  return csv_.row({frame.time, meanContent(frame, scene_)});
}

Result<FeedLog> FeedLog::create(const std::filesystem::path& path, const Scene& scene) {
  Result<CsvWriter> csv = CsvWriter::create(path, "time,particles,mass,entered,left");
  if (!csv) return csv.problems;
  return FeedLog(std::move(*csv), scene);
}

std::optional<Diagnostic> FeedLog::write(const Frame& frame) {
  if (!frame.id.empty()) newest_ = std::max(newest_, frame.id.back());
  double mass = 0.0;
  for (std::size_t i = 0; i < frame.size(); ++i) mass += massOf(scene_, frame, i);
  // Ids count up from 0.
  const double ever = static_cast<double>(newest_) + 1.0, there = static_cast<double>(frame.size());
  return csv_.row(
      {frame.time, there, mass, ever - static_cast<double>(scene_.particles.count), ever - there});
}

}  // namespace bedmix
