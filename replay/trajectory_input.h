// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "replay/hdf5_input.h"
#include "replay/provenance.h"
#include "replay/run_event.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// What HDF5 finds in a trajectory. It happens in a process of its own, see reader_process.h. Failures throw
// Hdf5Error.

namespace bedmix {

/// A scene as a file holds it.
struct SceneText {
  std::string text, name;
};
SceneText readSceneText(const Hdf5Input& in);

/// What a trajectory says once.
struct RunConstants {
  Provenance provenance;         // empty where it cannot be read
  std::vector<RunEvent> events;  // likewise
  std::size_t recorded = 0;      // frames there are said to be; of remains there may be fewer
  std::vector<std::int64_t> steps;
  std::vector<double> times;          // s, as many
  std::vector<std::uint8_t> species;  // empty with a feed, like all below
  std::vector<std::int32_t> id;
  std::vector<float> radius;  // m, empty where all are alike, like kind
  std::vector<std::uint8_t> kind;
};

/// Numbers of a frame that change with time. With a feed that are ids, too, whose bits stand in place of
/// floats, and species, radii and kinds as floats.
std::size_t numbersPerFrame(const Scene& scene);

class TrajectoryInput {
 public:
  /// Finds all that a run of the scene has recorded.
  TrajectoryInput(const Hdf5Input& in, const Scene& scene);

  const RunConstants& constants() const { return constants_; }
  /// What changes with time: the numbers of the rows, one after the other, in the order of
  /// trajectory_layout.h. `into` must have room for numbersPerFrame() of the scene.
  void readFrame(std::size_t index, float* into) const;
  /// What is there of a checkpoint; empty where that cannot be read.
  std::vector<std::byte> checkpoint(std::size_t slot) const;

 private:
  struct GasSeries {
    Hdf5Values voidage, pressure, velocity;
    std::optional<Hdf5Values> temperature;
  };
  static GasSeries openGas(const Hdf5Input& in, const Scene& scene);
  void readTimes();
  void expectToFollow(std::size_t index) const;
  struct FedSeries {
    Hdf5Values id, species;
    std::optional<Hdf5Values> radius, kind;
  };
  static FedSeries openFed(const Hdf5Input& in, const Scene& scene);
  float* readFed(std::size_t index, float* into) const;
  void readSpecies();
  void readKinds();

  const Hdf5Input& in_;
  hsize_t particles_;
  Hdf5Values position_, velocity_;
  std::optional<Hdf5Values> angularVelocity_, temperature_, content_;
  std::optional<FedSeries> fed_;  // with a feed
  std::size_t kinds_;             // of particles
  std::optional<GasSeries> gas_;
  RunConstants constants_;
};

}  // namespace bedmix
