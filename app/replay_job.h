// SPDX-License-Identifier: MIT
#pragma once

#include "app/frame_selection.h"
#include "app/recorded_runs.h"
#include "replay/analysis/analysis.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// What is derived anew from recorded runs, and how.
struct ReplaySettings {
  std::string sampling;            // "CxR"; the scene's where empty
  std::string minParticles;        // as TOML, likewise
  std::string tracer;              // see TracerChoice; as recorded where empty
  std::optional<double> tracerAt;  // s, the frame the tracer is chosen in; the first where there is none
  FrameSelection frames;
  std::string analyses;                    // comma-separated names of analysisKinds(), or "all"
  std::vector<std::vector<double>> lines;  // x and y of both ends, m, to take the flux through
};

/// What came of one run.
struct Replayed {
  std::filesystem::path folder;     // of the series
  std::vector<std::string> series;  // names of the tables there, without ".csv"
  std::size_t frames = 0;
  double from = 0.0, to = 0.0;  // s
  std::vector<FoundNumber> findings;
};

/// Derives the series of a run, and what the analyses find, from its frames into a folder, which is made.
/// Every frame goes to `watching` too, where there is one.
Result<Replayed> replayRun(RecordedRun& run, const ReplaySettings& settings,
                           const std::filesystem::path& into, FrameSink* watching = nullptr);

}  // namespace bedmix
