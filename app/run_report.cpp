// SPDX-License-Identifier: MIT
#include "app/run_report.h"

#include "app/version.h"
#include "engine/core/simd.h"

#include <fmt/format.h>

namespace bedmix {

RunSummary summarize(const RunPlan& plan, const RunOutcome& outcome) {
  const Scene& scene = plan.scene;
  const RunEnd& end = outcome.end;
  RunSummary s;
  s.scene = scene.name;
  s.seed = scene.seed;
  s.version = programVersion;
  s.commit = programCommit;
  s.simulatedSeconds = end.simulatedSeconds;
  s.wallSeconds = end.wallSeconds;
  s.steps = end.steps;
  s.gasSteps = end.gasSteps;
  if (end.wallSeconds > 0.0)
    s.particleStepsPerSecond =
        static_cast<double>(end.steps) * static_cast<double>(scene.particles.count) / end.wallSeconds;
  for (std::size_t i = 0; i < end.stages.size(); ++i) s.stages.emplace_back(stageNames[i], end.stages[i]);
  s.threads = plan.threads;
  s.simd = simdLevelNames()[static_cast<std::size_t>(simdLevel())];
  s.stateHash = end.stateHash;
  s.endReason = end.reason == EndReason::finished  ? "finished"
                : end.reason == EndReason::stopped ? "stopped"
                                                   : "invalid";
  s.retries = outcome.retries;
  return s;
}

void reportSteps(const Console& console, const Scene& scene, const StepReport& report) {
  if (report.largestOverlap > scene.limits.warnOverlap)
    console.warn(
        fmt::format("the largest overlap was {:.2g} of a diameter (particle {}); raise contacts.stiffness",
                    report.largestOverlap, report.largestOverlapParticle));
  if (report.aboveGridLargest > 0)
    console.say(fmt::format("up to {} particles at a time were above the gas grid and fell without gas",
                            report.aboveGridLargest));
  if (report.waitingLargest > 0)
    console.warn(fmt::format(
        "up to {} particles found no room to come in and waited; lower the rates of feed.streams, "
        "widen their lines or raise feed.most",
        report.waitingLargest));
  if (report.largestCourant > 1.0)
    console.warn(
        fmt::format("gas passed {:.2g} cells in a step, where time is resolved below 1; lower gas.step",
                    report.largestCourant));
  if (report.gasStepsNotConverged > 0)
    console.warn(
        fmt::format("{} gas steps ended at the iteration limit; lower gas.step or raise gas.max_iterations",
                    report.gasStepsNotConverged));
}

}  // namespace bedmix
