// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

class ThreadTeam;
struct Particles;

/// The stages of a step, in their order; one timer each.
enum class Stage { neighbours, voidage, drag, gas, effects, contacts, integrate, count };
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Stage::count)> stageNames{
    "neighbours", "voidage", "drag", "gas", "effects", "contacts", "integrate"};
using StageSeconds = std::array<double, static_cast<std::size_t>(Stage::count)>;

/// What the run has met so far.
struct StepReport {
  double largestOverlap = 0.0;  // of a diameter
  std::int64_t largestOverlapParticle = -1;
  std::int64_t gasStepsNotConverged = 0;
  double largestMassResidual = 0.0;   // of the gas, relative to the inflow
  double largestCourant = 0.0;        // of the gas: cells it passes in a step
  double lowestVoidage = 1.0;         // of a cell
  std::int64_t aboveGridLargest = 0;  // particles above the gas grid at one time
  double largestSpeed = 0.0;          // m/s, at a gas step or the end of a call
  std::int64_t largestSpeedParticle = -1;
  std::int64_t waitingLargest = 0;  // particles at one time that found no room to come in
};

/// How many of `cores` threads pay off for a bed: below some 10,000 particles they wait for each other longer
/// than they gain, above each has work from 4,096 on.
int threadsFor(std::int64_t particles, int cores);

/// A bed and its gas, advanced step by step: the list of stages and nothing else. Two simulations of one
/// scene are the same to the bit. Not thread-safe; one thread owns it (see Worker).
class Simulation {
 public:
  /// Arranges the particles (settling takes seconds for the paper's bed) and fills the bed with still gas.
  /// `threads` never changes a result. Fails where the particles find no room or settling breaks the overlap
  /// limit.
  static Result<Simulation> make(const Scene& scene, int threads = 1);
  /// Takes the bed as it stands in `start`, which must fit the scene.
  static Simulation make(const Scene& scene, Particles start, int threads = 1);
  /// Goes on from what save() wrote of a simulation of the same scene; whatever the numbers of threads, both
  /// stay the same to the bit. Of a scene with longer steps, a step then was `stepsPerStep` of this scene's.
  /// Empty where `in` is not that.
  static std::optional<Simulation> make(const Scene& scene, StateReader& in, int threads = 1,
                                        std::int64_t stepsPerStep = 1);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Advances by `steps` ticks, which are particle steps where the scene gives their length. Automatic steps
  /// are cut where a call ends, so that they depend on it unless it ends with a frame or a gas step. Empty
  /// when the solution is valid; else what went wrong (which particle, which stage, what time, what to do),
  /// and the simulation must not be advanced further.
  [[nodiscard]] std::optional<std::string> advance(std::int64_t steps);
  /// Whether what went wrong there did so in the gas.
  bool gasFailed() const;

  /// Changes what the gas enters through, from the next gas step on. The scene must have gas and the inlets
  /// must fit its floor.
  void setInlets(const std::vector<Inlet>& inlets);
  /// Goes on by another scene, which steeredScene() has made of its own. Where both are the same, so is what
  /// comes, to the bit. False, and nothing has changed, where it could not be advanced further anyway.
  [[nodiscard]] bool steer(const Scene& scene);
  /// Chooses the tracer anew, from where the particles are.
  void setTracer(TracerRule rule);

  std::int64_t step() const;  // in ticks
  double time() const;
  std::int64_t particleSteps() const;
  std::int64_t gasSteps() const;
  FramePtr frame() const;
  /// Of the whole double state, in the order of the ids.
  std::uint64_t stateHash() const;
  /// Touching pairs and wall contacts at the last step.
  std::int64_t contacts() const;
  const StageSeconds& stageSeconds() const;
  const StepReport& report() const;

  /// Everything its future and its reports depend on but the scene.
  void save(StateWriter& out) const;

 private:
  Simulation(const Scene& scene, Particles start, std::unique_ptr<ThreadTeam> team);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
