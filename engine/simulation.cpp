// SPDX-License-Identifier: MIT
#include "engine/simulation.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/hash.h"
#include "engine/core/particle_list.h"
#include "engine/core/period.h"
#include "engine/core/walls.h"
#include "engine/coupled_gas.h"
#include "engine/dem/packing.h"
#include "engine/dem/particle_solver.h"
#include "engine/dem/particle_step.h"
#include "engine/effects/effect_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace bedmix {

namespace {

/// Below this the drag laws mean nothing and the gas equations lose their diagonal; spheres in a slab of
/// their own diameter reach 0.40 at the densest packing without overlap.
constexpr double voidageFloor = 0.15;
/// The pressure is solved to 1e-12 of the inflow; this far off it was not.
constexpr double worstMassResidual = 1e-6;

/// Adds the time since the last call to a stage.
class StageClock {
 public:
  explicit StageClock(StageSeconds& seconds) : seconds_(seconds), last_(Clock::now()) {}
  void lap(Stage stage) {
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  StageSeconds& seconds_;
  Clock::time_point last_;
};

std::string inCell(const GasGrid& grid, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  const std::size_t column = cell % columns, row = cell / columns;
  return fmt::format("in the cell at x = {:.4g} m, y = {:.4g} m", 0.5 * (grid.x[column] + grid.x[column + 1]),
                     0.5 * (grid.y[row] + grid.y[row + 1]));
}

}  // namespace

int threadsFor(std::int64_t particles, int cores) {
  constexpr std::int64_t fewest = 10000, perThread = 4096;
  if (particles < fewest) return 1;
  return static_cast<int>(std::clamp<std::int64_t>(particles / perThread, 1, std::max(1, cores)));
}

/// The largest divisor of `whole` that is at most `most` and a multiple of `part`, whose other factors are
/// primes[first] and above; `part` where there is none.
std::int64_t largestDivisor(std::int64_t whole, double most, std::int64_t part = 1, std::size_t first = 0) {
  constexpr std::array<std::int64_t, 4> primes{2, 3, 5, 7};
  std::int64_t largest = part;
  for (std::size_t p = first; p < primes.size(); ++p)
    if (const std::int64_t next = part * primes[p]; static_cast<double>(next) <= most && whole % next == 0)
      largest = std::max(largest, largestDivisor(whole, most, next, p));
  return largest;
}

/// Ticks, one at least, that fit into `seconds` and divide both a frame and what of it has passed by tick
/// `at`, so that equal ones fill it.
std::int64_t ticksWithin(double seconds, const Scene& scene, std::int64_t at) {
  const double most = seconds / tick(scene) * (1.0 + 1e-9);
  return largestDivisor(std::gcd(stepsPerFrame(scene), at), most);
}

struct Simulation::State {
  Scene scene;
  std::unique_ptr<ThreadTeam> team;
  std::unique_ptr<ParticleSolver> solver;
  std::unique_ptr<CoupledGas> gas;
  std::vector<std::unique_ptr<EffectStage>> effects;
  std::vector<std::uint8_t> species;       // by row
  std::vector<double> temperature;         // K, by row; empty without heat
  std::optional<ParticleStep> chosenStep;  // where the scene gives none
  std::int64_t step = 0, particleSteps = 0, gasSteps = 0;
  std::int64_t stretch = 0;     // ticks from one gas step, or choice of steps, to the next
  std::int64_t stretchEnd = 0;  // step of the next
  StageSeconds seconds{};
  StepReport report;
  bool gasFailed = false;

  std::int64_t nextStretch() const;
  void letInAndOut();
  void actOut(std::int64_t before);
  std::optional<std::string> gasStep();
  ParticleStep::Outcome moveParticles(std::int64_t ticks);
  std::optional<std::string> advanceParticles(std::int64_t ticks);
  bool load(StateReader& in, std::int64_t stepsPerStep);
};

// Gas steps fall on whole multiples of their length, wherever a call begins.
std::int64_t Simulation::State::nextStretch() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const auto& effect : effects) longest = std::min(longest, effect->longestStep());
  if (gas && !gas->chosenStep) return stepsPerGasStep(scene);
  if (gas) return ticksWithin(std::min(longest, gas->longestStep()), scene, step);
  if (chosenStep) longest = std::min(longest, contactTimeScale(scene));
  return std::isfinite(longest) ? ticksWithin(longest, scene, step) : stepsPerFrame(scene);
}

/// After the present stretch.
void Simulation::State::letInAndOut() {
  StageClock clock(seconds);
  const double passed = static_cast<double>(stretch) * tick(scene);
  for (const auto& effect : effects) {
    const PopulationChange change = effect->exchange(passed);
    report.waitingLargest = std::max(report.waitingLargest, effect->waiting());
    if (change.empty()) continue;
    change.apply(species, [this](const PopulationChange::Newcomer& newcomer) {
      return tagOfFed(scene.tracer.rule, newcomer.kind);
    });
    for (const auto& other : effects) other->follow(change);
  }
  clock.lap(Stage::effects);
}

/// After a stretch of `before` ticks, with the coming one chosen.
void Simulation::State::actOut(std::int64_t before) {
  const double length = tick(scene);
  for (const auto& effect : effects)
    effect->act(static_cast<double>(before) * length, static_cast<double>(stretch) * length);
}

std::optional<std::string> Simulation::State::gasStep() {
  Particles& particles = solver->particles();
  StageClock clock(seconds);
  gas->voidage.update(particles.position, particles.radii);
  report.aboveGridLargest = std::max(report.aboveGridLargest, gas->voidage.aboveGrid());
  const double lowest = gas->voidage.lowest();
  clock.lap(Stage::voidage);
  report.lowestVoidage = std::min(report.lowestVoidage, lowest);
  if (!(lowest > voidageFloor)) {
    const std::vector<double>& voidage = gas->voidage.voidage();
    const auto cell = std::min_element(voidage.begin(), voidage.end()) - voidage.begin();
    return fmt::format(
        "voidage {:.3g} {} (voidage) at t = {:.6g} s is below {}: particles overlap too far for the gas "
        "equations; use a stiffer contact (contacts.stiffness) or a smaller time.step",
        lowest, inCell(gas->solver.grid(), static_cast<std::size_t>(cell)), timeOfStep(scene, step),
        voidageFloor);
  }

  const std::int64_t before = stretch;
  stretch = nextStretch();
  const double length = static_cast<double>(stretch) * tick(scene);
  gas->setStep(length);
  if (gas->flow) gas->solver.setInletFlux(gas->flow->over(timeOfStep(scene, step), length));
  gas->exchange.evaluateDrag(particles, gas->solver.exchange());
  const bool isCharged =
      std::any_of(effects.begin(), effects.end(), [](const auto& effect) { return effect->chargesGas(); });
  if (isCharged && gas->chosenStep) gas->drag = gas->solver.exchange();
  for (const auto& effect : effects) effect->chargeGas(length, gas->solver.exchange());
  clock.lap(Stage::drag);
  const GasStepReport r = gas->solver.advance(gas->voidage.voidage());
  ++gasSteps;
  report.gasStepsNotConverged += !r.converged;
  report.largestMassResidual = std::max(report.largestMassResidual, r.massResidual);
  report.largestCourant = std::max(report.largestCourant, r.courant);
  clock.lap(Stage::gas);
  gasFailed = !r.solved || r.massResidual > worstMassResidual;
  if (!r.solved)
    return fmt::format("the gas has no finite solution (gas) at t = {:.6g} s; use a smaller gas.step",
                       timeOfStep(scene, step));
  if (r.massResidual > worstMassResidual)
    return fmt::format(
        "a cell of the gas lacks {:.3g} of all that enters (gas) at t = {:.6g} s, more than {}: its pressure "
        "could not be solved; use a smaller gas.step",
        r.massResidual, timeOfStep(scene, step), worstMassResidual);

  if (gas->chosenStep)
    gas->chosenStep->observe(gas->solver, isCharged ? gas->drag : gas->solver.exchange(), r, length,
                             static_cast<double>(before) * tick(scene));
  gas->exchange.applyForces(particles);
  clock.lap(Stage::drag);
  actOut(before);
  clock.lap(Stage::effects);
  return std::nullopt;
}

ParticleStep::Outcome Simulation::State::moveParticles(std::int64_t ticks) {
  const double length = tick(scene);
  if (chosenStep) {
    solver->setTime(timeOfStep(scene, step));
    return chosenStep->advance(static_cast<double>(ticks) * length, *solver);
  }
  solver->setTime(0.0, step);
  std::optional<DemTrouble> trouble = solver->advance(ticks);
  const std::int64_t taken = trouble ? trouble->steps : ticks;
  return {taken, static_cast<double>(taken) * length, trouble};
}

std::optional<std::string> Simulation::State::advanceParticles(std::int64_t ticks) {
  const DemSeconds before = solver->seconds();
  const auto [taken, gone, trouble] = moveParticles(ticks);
  const DemSeconds& after = solver->seconds();
  seconds[static_cast<std::size_t>(Stage::neighbours)] += after.neighbours - before.neighbours;
  seconds[static_cast<std::size_t>(Stage::contacts)] += after.contacts - before.contacts;
  seconds[static_cast<std::size_t>(Stage::integrate)] += after.integrate - before.integrate;
  particleSteps += taken;
  step += trouble ? std::llround(gone / tick(scene)) : ticks;
  report.largestOverlap = solver->largestOverlap();
  report.largestOverlapParticle = solver->largestOverlapParticle();
  if (const auto fastest = solver->fastest(); fastest.speed > report.largestSpeed) {
    report.largestSpeed = fastest.speed;
    report.largestSpeedParticle = fastest.particle;
  }
  if (!trouble) return std::nullopt;
  gasFailed = trouble->stage == std::string_view("drag");
  const double time = timeOfStep(scene, step);
  if (trouble->kind == DemTrouble::Kind::speed)
    return fmt::format(
        "particle {} moves {:.3g} of its diameter in a step ({}) at t = {:.6g} s, more than {}: it could "
        "pass "
        "walls unseen; use a smaller time.step",
        trouble->particle, trouble->value, trouble->stage, time, furthestInAStep);
  if (trouble->kind == DemTrouble::Kind::nonFinite)
    return fmt::format("particle {} is no longer finite ({}) at t = {:.6g} s; use a smaller time.step",
                       trouble->particle, trouble->stage, time);
  return fmt::format(
      "particle {} overlaps by {:.3g} of a diameter ({}) at t = {:.6g} s, more than limits.max_overlap = "
      "{}; use a stiffer contact (contacts.stiffness), a smaller time.step, or a wider limit",
      trouble->particle, trouble->value, trouble->stage, time, scene.limits.maxOverlap);
}

Result<Simulation> Simulation::make(const Scene& scene, int threads) {
  auto team = std::make_unique<ThreadTeam>(threads);
  Result<Particles> start = packBed(scene, *team);
  if (!start) return start.problems;
  return Simulation(scene, std::move(*start), std::move(team));
}

Simulation Simulation::make(const Scene& scene, Particles start, int threads) {
  return Simulation(scene, std::move(start), std::make_unique<ThreadTeam>(threads));
}

Simulation::Simulation(const Scene& scene, Particles start, std::unique_ptr<ThreadTeam> team)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.scene = scene;
  s.team = std::move(team);
  s.solver = ParticleSolver::make(scene, std::move(start), allWalls(scene), *s.team);
  if (scene.time.step.isAutomatic()) s.chosenStep.emplace(scene);
  if (scene.gas) s.gas = std::make_unique<CoupledGas>(scene, s.solver->particles(), *s.team);
  s.effects =
      effectStages({s.scene, *s.solver, s.gas ? &s.gas->solver : nullptr, s.gas ? &s.gas->voidage : nullptr,
                    s.gas ? &s.gas->exchange : nullptr, *s.team, s.temperature});
  s.stretch = s.stretchEnd = s.nextStretch();
  if (s.gas) s.gas->start(static_cast<double>(s.stretch) * tick(scene));
  setTracer(scene.tracer.rule);
}

void Simulation::save(StateWriter& out) const {
  const State& s = *state_;
  if (s.scene.effects.find<FeedSettings>()) {
    out.put(static_cast<std::uint64_t>(s.solver->particles().size()));
    out.put(s.report.waitingLargest);
  }
  out.put(s.step);
  out.put(s.particleSteps);
  out.put(s.gasSteps);
  out.put(s.stretch);
  out.put(s.stretchEnd);
  out.put(s.seconds);
  out.put(s.report.largestOverlap);
  out.put(s.report.largestOverlapParticle);
  out.put(s.report.gasStepsNotConverged);
  out.put(s.report.largestMassResidual);
  out.put(s.report.largestCourant);
  out.put(s.report.lowestVoidage);
  out.put(s.report.aboveGridLargest);
  out.put(s.report.largestSpeed);
  out.put(s.report.largestSpeedParticle);
  out.putAll(s.species);
  out.putAll(s.solver->roster().ids());
  s.solver->save(out);
  if (s.chosenStep) s.chosenStep->save(out);
  if (s.gas) s.gas->solver.save(out);
  if (s.gas && s.gas->chosenStep) s.gas->chosenStep->save(out);
  for (const auto& effect : s.effects) effect->save(out);
}

bool Simulation::State::load(StateReader& in, std::int64_t stepsPerStep) {
  const auto getCount = [&in](auto& count) {
    constexpr std::int64_t most = std::int64_t{1} << 53;  // no run counts that far
    return in.get(count) && count >= 0 && count < most;
  };
  const auto getTicks = [&](std::int64_t& ticks) {
    if (!getCount(ticks)) return false;
    ticks *= stepsPerStep;
    return true;
  };
  std::vector<std::int32_t> ids(species.size());
  return getTicks(step) && getCount(particleSteps) && getCount(gasSteps) && getTicks(stretch) &&
         getTicks(stretchEnd) && stretchEnd > step && stretchEnd - step <= stretch && in.get(seconds) &&
         in.get(report.largestOverlap) && in.get(report.largestOverlapParticle) &&
         getCount(report.gasStepsNotConverged) && in.get(report.largestMassResidual) &&
         in.get(report.largestCourant) && in.get(report.lowestVoidage) && in.get(report.aboveGridLargest) &&
         in.get(report.largestSpeed) && in.get(report.largestSpeedParticle) && in.getAll(species) &&
         in.getAll(ids) && solver->load(in) && ids == solver->roster().ids() &&
         (solver->roster().isDense() || scene.effects.find<FeedSettings>()) &&
         (!chosenStep || chosenStep->load(in)) &&
         (!gas || (gas->solver.load(in) && (!gas->chosenStep || gas->chosenStep->load(in)))) &&
         std::all_of(effects.begin(), effects.end(), [&](const auto& effect) { return effect->load(in); });
}

std::optional<Simulation> Simulation::make(const Scene& scene, StateReader& in, int threads,
                                           std::int64_t stepsPerStep) {
  auto count = static_cast<std::uint64_t>(scene.particles.count);
  std::int64_t waiting = 0;
  if (const FeedSettings* feed = scene.effects.find<FeedSettings>())
    if (!in.get(count) || count > static_cast<std::uint64_t>(feed->most) || !in.get(waiting) || waiting < 0)
      return std::nullopt;
  const std::vector<Vec2> anywhere(count);
  Simulation simulation(scene, makeParticles(scene, anywhere), std::make_unique<ThreadTeam>(threads));
  if (!simulation.state_->load(in, stepsPerStep)) return std::nullopt;
  simulation.state_->report.waitingLargest = waiting;
  return simulation;
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

std::optional<std::string> Simulation::advance(std::int64_t steps) {
  State& s = *state_;
  for (std::int64_t left = steps; left > 0;) {
    const std::int64_t chunk = std::min(left, s.stretchEnd - s.step);
    if (auto trouble = s.advanceParticles(chunk)) return trouble;
    left -= chunk;
    if (s.step < s.stretchEnd) return std::nullopt;
    s.letInAndOut();
    if (s.gas) {
      if (auto trouble = s.gasStep()) return trouble;
    } else {
      StageClock clock(s.seconds);
      s.actOut(std::exchange(s.stretch, s.nextStretch()));
      clock.lap(Stage::effects);
    }
    s.stretchEnd = s.step + s.stretch;
  }
  return std::nullopt;
}

void Simulation::setInlets(const std::vector<Inlet>& inlets) {
  State& s = *state_;
  s.scene.gas->inlets = inlets;
  s.gas->setInlets(s.scene);
  if (s.gas->flow) return;  // which sets what enters before each step
  const std::vector<double> flux = makeGasGrid(s.scene).inletFlux;
  if (flux == s.gas->solver.grid().inletFlux) return;
  s.gas->solver.setInletFlux(flux);
  if (s.gas->chosenStep) s.gas->chosenStep->expect(s.gas->solver, fastestInlet(s.scene));
}

bool Simulation::steer(const Scene& scene) {
  StateWriter out(0);
  save(out);
  const std::vector<std::byte> bytes = out.take();
  StateReader in(bytes);
  std::optional<Simulation> next = make(scene, in, state_->team->size());
  if (!next || !in.done()) return false;
  if (scene.gas) next->setInlets(scene.gas->inlets);
  *this = std::move(*next);
  return true;
}

void Simulation::setTracer(TracerRule rule) {
  State& s = *state_;
  s.scene.tracer.rule = rule;
  const Particles byId = inOrderOfIds(s.solver->particles());
  std::vector<Vec2f> position;
  for (const Vec2 at : byId.position) position.push_back(toFloat(at));
  s.species = tagTracer(rule, position, byId.kinds, s.scene.bed.width);
}

bool Simulation::gasFailed() const { return state_->gasFailed; }
std::int64_t Simulation::step() const { return state_->step; }
std::int64_t Simulation::particleSteps() const { return state_->particleSteps; }
double Simulation::time() const { return timeOfStep(state_->scene, state_->step); }
std::int64_t Simulation::gasSteps() const { return state_->gasSteps; }
std::int64_t Simulation::contacts() const { return state_->solver->contactCount(); }
const StageSeconds& Simulation::stageSeconds() const { return state_->seconds; }
const StepReport& Simulation::report() const { return state_->report; }

FramePtr Simulation::frame() const {
  const State& s = *state_;
  const Particles& p = s.solver->particles();
  const Period period(s.scene);
  auto frame = std::make_shared<Frame>();
  frame->step = s.step;
  frame->time = time();
  frame->species = s.species;
  const Roster& roster = s.solver->roster();
  frame->id = roster.ids();
  frame->radius.resize(p.radii.size());
  frame->kind.resize(p.kinds.size());
  frame->position.resize(p.size());
  frame->velocity.resize(p.size());
  frame->angularVelocity.resize(p.spin.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t row = roster.rowOf(p.id[i]);
    frame->position[row] = period.rounded(p.position[i]);
    frame->velocity[row] = toFloat(p.velocity[i]);
    if (!p.spin.empty()) frame->angularVelocity[row] = static_cast<float>(p.spin[i]);
    if (!p.areMixed()) continue;
    frame->radius[row] = static_cast<float>(p.radii[i]);
    frame->kind[row] = p.kinds[i];
  }
  if (s.gas) frame->gas = gasFrame(s.gas->solver);
  for (const auto& effect : s.effects) effect->fill(*frame);
  return frame;
}

std::uint64_t Simulation::stateHash() const {
  const State& s = *state_;
  StateHash hash;
  hash.add(static_cast<std::uint64_t>(s.step));
  s.solver->hashInto(hash);
  if (s.gas) {
    hash.add(s.gas->solver.fields().velocity);
    hash.add(s.gas->solver.fields().pressure);
    hash.add(s.gas->solver.fields().voidage);
  }
  for (const auto& effect : s.effects) effect->hashInto(hash);
  return hash.value();
}

}  // namespace bedmix
