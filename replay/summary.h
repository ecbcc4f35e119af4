// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bedmix {

/// A run whose solution became invalid, and that went back to go on with shorter steps.
struct Retry {
  double time = 0.0;  // s, of the trouble
  double from = 0.0;  // s, it went on from
  std::string reason;
  std::vector<std::pair<std::string, double>> settings;  // changed, by their paths

  bool operator==(const Retry&) const = default;
};

/// What summary.json tells of a run beside its settings.
struct RunSummary {
  std::string scene;  // name
  std::uint64_t seed = 0;
  std::string version;
  std::string commit;
  double simulatedSeconds = 0.0;
  double wallSeconds = 0.0;
  std::int64_t steps = 0;
  std::int64_t gasSteps = 0;
  double particleStepsPerSecond = 0.0;                 // per second of wall time
  std::vector<std::pair<std::string, double>> stages;  // wall seconds by stage, in the order of a step
  int threads = 1;
  std::string simd;  // the instructions the vector loops used
  std::uint64_t stateHash = 0;
  std::string endReason;       // finished, stopped, invalid
  std::vector<Retry> retries;  // since the run was begun or resumed
};

/// Writes summary.json with `scene` as its resolved settings. The file appears whole or not at all.
std::optional<Diagnostic> writeSummary(const std::filesystem::path& path, const RunSummary& summary,
                                       const Scene& scene);

/// Reads it back. The settings are there for people and scripts; bedmix takes a run's scene from its
/// trajectory.
Result<RunSummary> readSummary(const std::filesystem::path& path);

}  // namespace bedmix
