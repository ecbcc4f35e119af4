// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/mixing.h"
#include "engine/core/scene.h"
#include "replay/csv.h"
#include "replay/file_sink.h"

#include <cstdint>
#include <filesystem>

// The series of a run as CSV, one row a frame. `run` and `replay` feed the same frames to the same sinks, so
// their files are the same bytes.

namespace bedmix {

/// mixing.csv: the indices over the cells of a sampling grid, see MixingSample.
class MixingLog final : public FileSink {
 public:
  static Result<MixingLog> create(const std::filesystem::path& path, const SamplingGrid& grid);

 private:
  MixingLog(CsvWriter csv, const SamplingGrid& grid) : csv_(std::move(csv)), grid_(grid) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  SamplingGrid grid_;
};

/// flux.csv: solids flux through the scene's window, kg/(m2 s), positive leftward. The scene must have a flux
/// table.
class FluxLog final : public FileSink {
 public:
  static Result<FluxLog> create(const std::filesystem::path& path, const Scene& scene);

 private:
  FluxLog(CsvWriter csv, const Scene& scene) : csv_(std::move(csv)), scene_(scene) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  Scene scene_;
};

/// pressure.csv: pressure drop, Pa, and height of the bed, m. The scene must have gas.
class PressureLog final : public FileSink {
 public:
  static Result<PressureLog> create(const std::filesystem::path& path, const Scene& scene);

 private:
  PressureLog(CsvWriter csv, const Scene& scene)
      : csv_(std::move(csv)), scene_(scene), grid_(makeGasGrid(scene)) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  Scene scene_;
  GasGrid grid_;
};

/// heat.csv: mean temperature of the particles and of the gas that leaves, K, the latter empty without gas,
/// and heat of the particles, J, see particleHeat(). The scene must have heat.
class HeatLog final : public FileSink {
 public:
  static Result<HeatLog> create(const std::filesystem::path& path, const Scene& scene);

 private:
  HeatLog(CsvWriter csv, const Scene& scene) : csv_(std::move(csv)), scene_(scene) {
    if (scene.gas) grid_ = makeGasGrid(scene);
  }
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  Scene scene_;
  std::optional<GasGrid> grid_;
};

/// reaction.csv: what the particles' mass holds of the content on average, kg/kg; empty without particles.
/// The scene must have a reaction.
class ReactionLog final : public FileSink {
 public:
  static Result<ReactionLog> create(const std::filesystem::path& path, const Scene& scene);

 private:
  ReactionLog(CsvWriter csv, const Scene& scene) : csv_(std::move(csv)), scene_(scene) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  Scene scene_;
};

/// feed.csv: particles there and their mass, kg; those who have come in and gone since the run began. The
/// scene must have a feed.
class FeedLog final : public FileSink {
 public:
  static Result<FeedLog> create(const std::filesystem::path& path, const Scene& scene);

 private:
  FeedLog(CsvWriter csv, const Scene& scene)
      : csv_(std::move(csv)), scene_(scene), newest_(static_cast<std::int32_t>(scene.particles.count) - 1) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  CsvWriter csv_;
  Scene scene_;
  std::int32_t newest_;  // id
};

}  // namespace bedmix
