// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "replay/foreign/foreign_scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bedmix {

/// What the command line says of files of other programs. Runs of bedmix say all this themselves.
struct RecordingOptions {
  std::string scene;  // path or bundled name
  std::string plane;
  std::string group;
  std::vector<double> bed;         // m: left, lower, right, upper edge
  std::optional<double> diameter;  // m
  std::optional<double> timeStep;  // s
  std::optional<std::int64_t> tracerSpecies;
};
void addRecordingOptions(CLI::App& command, RecordingOptions& options);

/// Fails on a scene that is none and a bed without width or height.
Result<ForeignOptions> foreignOptions(const RecordingOptions& options);

}  // namespace bedmix
