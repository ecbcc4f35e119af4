// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/hash.h"
#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/core/thread_team.h"
#include "engine/dem/population.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace bedmix {

class Exchange;
class GasSolver;
class ParticleSolver;
class VoidageField;
struct MomentumExchange;

/// What an effect works on. What belongs to the gas is null without gas.
struct EffectContext {
  const Scene& scene;
  ParticleSolver& solver;
  GasSolver* gas;
  VoidageField* voidage;
  Exchange* exchange;
  ThreadTeam& team;
  /// Of particles, K, by row of the roster; empty without heat.
  std::vector<double>& temperature;
};

/// An effect at work, as part of every gas step; without gas, of every stretch of particle steps. Those that
/// only change how bodies touch are part of the contact law instead.
class EffectStage {
 public:
  virtual ~EffectStage() = default;

  /// The longest that a step of its may be where it has a limit of its own, s.
  virtual double longestStep() const { return std::numeric_limits<double>::infinity(); }
  /// Whether chargeGas() does anything.
  virtual bool chargesGas() const { return false; }
  /// Adds what the gas gets in the step (s) that comes to what it gets by drag.
  virtual void chargeGas([[maybe_unused]] double step, [[maybe_unused]] MomentumExchange& exchange) {}
  /// Before the gas looks at the particles: who comes and goes after the stretch of `passed` s that is over.
  /// The stage tells the solver and the gas of it; whatever else keeps something for each particle follows.
  virtual PopulationChange exchange([[maybe_unused]] double passed) { return {}; }
  virtual void follow([[maybe_unused]] const PopulationChange& change) {}
  /// After the gas has taken the step and the particles know what it does to them: what has happened to them
  /// since the last call, `passed` s ago, and what will in the `step` (s) to the next.
  virtual void act([[maybe_unused]] double passed, [[maybe_unused]] double step) {}

  /// Particles that find no room to come in.
  virtual std::int64_t waiting() const { return 0; }
  virtual void fill([[maybe_unused]] Frame& frame) const {}
  virtual void hashInto([[maybe_unused]] StateHash& hash) const {}
  // What it keeps beside the columns of Particles; see state_bytes.h.
  virtual void save([[maybe_unused]] StateWriter& out) const {}
  [[nodiscard]] virtual bool load([[maybe_unused]] StateReader& in) { return true; }
};

/// Those that the scene calls for, in the order in which they act. What the context refers to must outlive
/// them.
std::vector<std::unique_ptr<EffectStage>> effectStages(const EffectContext& context);

}  // namespace bedmix
