// SPDX-License-Identifier: MIT
#include "app/report/run_record.h"

#include "app/run_folder.h"
#include "replay/summary.h"

#include <fmt/format.h>

#include <optional>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Empty where there is none.
Result<std::optional<RunSummary>> summaryOf(const RecordedRun& run) {
  const fs::path file = RunFolder{run.folder}.summary();
  std::error_code none;
  if (!fs::exists(file, none)) return std::optional<RunSummary>();
  auto summary = readSummary(file);
  if (!summary) return summary.problems;
  return std::optional(std::move(*summary));
}

Rows provenance(const RecordedRun& run, const std::optional<RunSummary>& summary) {
  const Provenance& from = run.reader->provenance();
  Rows rows{
      {"scene", run.scene().name},
      {"seed", fmt::format("{}", run.scene().seed)},
      {"recorded by", from.version.empty() ? "-" : fmt::format("bedmix {} ({})", from.version, from.commit)},
      {"frames", fmt::format("{}, from {:g} to {:g} s", run.reader->times().size(),
                             run.reader->times().front(), run.end())}};
  if (!summary) return rows;
  rows.push_back({"ended", fmt::format("{} at {:g} s", summary->endReason, summary->simulatedSeconds)});
  rows.push_back({"steps", fmt::format("{} of particles, {} of gas", summary->steps, summary->gasSteps)});
  rows.push_back({"state hash at the end", fmt::format("{:016x}", summary->stateHash)});
  rows.push_back(
      {"wall time", fmt::format("{:.1f} s on {} thread{}, {}", summary->wallSeconds, summary->threads,
                                summary->threads == 1 ? "" : "s", summary->simd)});
  rows.push_back({"speed", fmt::format("{:.3g} million particle steps a second",
                                       1e-6 * summary->particleStepsPerSecond)});
  return rows;
}

Rows stageTimes(const RunSummary& summary) {
  Rows rows;
  double rest = summary.wallSeconds;
  const auto add = [&](const std::string& name, double seconds) {
    rows.push_back(
        {name, fmt::format("{:.2f}", seconds),
         fmt::format("{:.0f} %", summary.wallSeconds > 0.0 ? 100.0 * seconds / summary.wallSeconds : 0.0)});
  };
  for (const auto& [name, seconds] : summary.stages) {
    add(name, seconds);
    rest -= seconds;
  }
  add("recording and all else", rest);
  return rows;
}

}  // namespace

Result<Done> addRecord(HtmlPage& page, const RecordedRun& run) {
  const auto summary = summaryOf(run);
  if (!summary) return summary.problems;
  page.table({"", ""}, provenance(run, *summary));
  Rows events;
  for (const RunEvent& event : run.reader->events())
    events.push_back({fmt::format("{:g} s", event.time), event.kind, event.detail});
  page.table({"at", "event", ""}, events);
  if (*summary && !(*summary)->stages.empty())
    page.table({"stage", "wall time, s", "share"}, stageTimes(**summary));
  return Done{};
}

}  // namespace bedmix
