// SPDX-License-Identifier: MIT
#include "app/check_report.h"

#include "app/effect_prices.h"
#include "engine/core/gas_grid.h"
#include "engine/core/mixing.h"
#include "engine/core/thread_team.h"
#include "engine/coupling/gas_step.h"
#include "engine/dem/contact_error.h"
#include "engine/effects/advice.h"
#include "engine/effects/effects.h"
#include "engine/simulation.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

namespace bedmix {

namespace {

constexpr double fewSteps = 10.0;   // of a contact, of a drag relaxation
constexpr double muchMissed = 2.0;  // %, of a closing speed

class Report {
 public:
  explicit Report(const Scene& scene) : scene_(scene) {}

  std::vector<CheckRow> rows() {
    effects();
    advice();
    timeScales();
    particleStep();
    if (scene_.gas) gasStep(*scene_.gas);
    if (scene_.gas) gas(*scene_.gas);
    sizes();
    effort();
    prices();
    return std::move(rows_);
  }
  std::vector<CheckRow> effectsOnly() {
    effects();
    return std::move(rows_);
  }

 private:
  void add(std::string name, std::variant<double, std::string> value, std::string unit = "",
           std::string note = "") {
    rows_.push_back({section_, std::move(name), std::move(value), std::move(unit), std::move(note)});
  }
  void effect(std::string name, bool on, std::string note) {
    add(std::move(name), on ? "on" : "off", "", std::move(note));
  }

  void effects() {
    section_ = "effects";
    for (const EffectInfo& e : effectTable()) effect(std::string(e.name), e.isOn(scene_), e.note(scene_));
    effect("inclined distributor", scene_.floor.inclinationDeg > 0.0,
           scene_.floor.inclinationDeg > 0.0
               ? fmt::format("{:g} deg, {} for particles", scene_.floor.inclinationDeg,
                             modelName(scene_.floor.shape))
               : "floor.inclination_deg is 0");
    effect("lid", scene_.bed.top == BedTop::lid,
           scene_.bed.top == BedTop::lid ? "can hold the bed up for good"
                                         : "particles may rise above the bed's height");
    effect("flux window", scene_.flux.has_value(),
           scene_.flux ? fmt::format("at x = {:g} m", scene_.flux->x) : "no table [flux]");
  }

  void advice() {
    section_ = "advice";
    for (const EffectAdvice& a : effectAdvice(scene_)) {
      const auto info = std::find_if(effectTable().begin(), effectTable().end(),
                                     [&](const EffectInfo& e) { return e.table == a.table; });
      const std::string verdict = a.isOn == a.matters
                                      ? (a.isOn ? "on, and matters" : "off, and does not matter")
                                  : a.isOn ? "ON, BUT DOES NOT MATTER"
                                           : "OFF, BUT MATTERS";
      add(std::string(info->name), fmt::format("{:.3g}", a.value), "",
          fmt::format("{}: {}: {}", verdict, a.number, a.meaning));
    }
  }

  void prices() {
    section_ = "prices";
    const std::optional<EffectPrices> prices = measureEffectPrices(scene_);
    if (!prices) return add("all together", "not measured", "", "too large for a moment, or empty");
    add("all together", prices->whole, "ns",
        fmt::format("a particle and step, measured here packed side by side, {:.2g} contacts a particle",
                    prices->contacts));
    for (const EffectPrice& price : prices->effects)
      if (price.nanoseconds)
        add(price.name, *price.nanoseconds, "ns",
            "of these" + (price.with.empty() ? "" : fmt::format(", with {}", price.with)));
      else
        add(price.name, "not measured", "", "the scene cannot do without it");
  }

  void timeScales() {
    section_ = "time scales";
    const double mass = particleMass(scene_), k = normalStiffness(scene_);
    add("contact time scale T", contactTimeScale(scene_), "s", "2 pi sqrt(m/k)");
    if (const auto contact = contactDuration())
      add("duration of a contact", *contact, "s", "two particles, head-on");
    else
      add("duration of a contact", "none", "", "overdamped: particles do not rebound");
    if (scene_.gas)
      if (const double umf = minimumFluidizationVelocity(scene_); umf > 0.0 && scene_.gravity > 0.0)
        add("drag relaxation", umf / scene_.gravity, "s", "u_mf/g, of a particle in the packed bed");
    add("hardest impact", scene_.limits.maxOverlap * scene_.particles.diameter * std::sqrt(2.0 * k / mass),
        "m/s", "two particles, head-on: deeper than limits.max_overlap beyond it");
  }

  /// s; none where two particles do not rebound.
  std::optional<double> contactDuration() const {
    const double mass = particleMass(scene_), k = normalStiffness(scene_);
    const double damping = pairDamping(scene_) / (2.0 * std::sqrt(0.5 * mass * k));
    if (damping >= 1.0) return std::nullopt;
    return std::numbers::pi * std::sqrt(0.5 * mass / k) / std::sqrt(1.0 - damping * damping);
  }

  void particleStep() {
    section_ = "step margins";
    const double scale = contactTimeScale(scene_);
    const ContactError error(scene_);
    if (scene_.time.step.isAutomatic()) {
      add("particle step", automaticStep, "",
          fmt::format("at most T/14 = {:.3g} s; {}", longestStep(scene_), chosenSteps(error, scale)));
      return;
    }
    const double step = scene_.time.step;
    add("particle step", step, "s", fmt::format("T/{:.4g}; allowed from T/14 on", scale / step));
    if (const auto contact = contactDuration())
      add("steps in a contact", *contact / step, "",
          *contact / step < fewSteps ? "few: contacts begin and end within steps; lower time.step, or "
                                       "time.integrator = \"verlet-onset\""
                                     : "two particles, head-on");
    const double missed = 100.0 * error.at(step);
    add("contact error", missed, "%",
        fmt::format("of the closing speed, in the speed after a contact, at most{}",
                    missed > muchMissed ? "; lower time.step, or \"auto\"" : ""));
  }

  /// What a chosen step is for soft and hard impacts.
  std::string chosenSteps(const ContactError& error, double scale) const {
    const double unit = std::sqrt(scene_.gravity * scene_.particles.diameter);
    if (unit == 0.0) return fmt::format("T/{:.3g}", scale / error.largestStep(1.0, scene_.time.error));
    const auto at = [&](double speed) {
      return fmt::format("T/{:.3g} at {:.2g} m/s", scale / error.largestStep(speed, scene_.time.error * unit),
                         speed);
    };
    return fmt::format("{}, {}", at(unit), at(10.0 * unit));
  }

  void gasStep(const GasSettings& settings) {
    const double fastest = fastestInlet(scene_);
    const double smallest = smallestCellHeight(makeGasGrid(scene_));
    const double longest = longestGasStep(scene_);
    if (settings.step.isAutomatic()) {
      double most = std::min(longest, scene_.sampling.interval);
      if (fastest > 0.0) most = std::min(most, GasStep::courantLimit(settings) * smallest / fastest);
      add("gas step", automaticStep, "",
          fmt::format("at most {:.3g} s; as long as {:g} of the drag changes in", most, settings.error));
      return;
    }
    const double step = settings.step;
    add("gas step", step, "s",
        fmt::format("{}allowed up to {:.3g} s",
                    scene_.time.step.isAutomatic()
                        ? ""
                        : fmt::format("{:.0f} particle steps; ", step / scene_.time.step),
                    longest));
    if (fastest > 0.0) {
      const double courant = fastest * step / smallest;
      add("gas Courant number", courant, "",
          courant > 1.0 ? "above 1 at the fastest inlet: lower gas.step"
                        : "at the fastest inlet; stable below 1");
    }
    if (const double umf = minimumFluidizationVelocity(scene_); umf > 0.0 && scene_.gravity > 0.0) {
      const double steps = umf / scene_.gravity / step;
      add("gas steps a relaxation", steps, "",
          steps < fewSteps ? "few: the drag changes while it is held; lower gas.step" : "");
    }
  }

  void gas(const GasSettings& settings) {
    const GasGrid grid = makeGasGrid(scene_);
    const double umf = minimumFluidizationVelocity(scene_);
    section_ = "gas";
    if (umf > 0.0)
      add("u_mf", umf, "m/s", settings.minimumFluidizationVelocity ? "given" : "Wen & Yu (1966)");
    else
      add("u_mf", "none", "", "these particles do not sink in the gas");
    for (std::size_t i = 0; i < settings.inlets.size(); ++i) {
      const Inlet& inlet = settings.inlets[i];
      const double u = inletVelocity(scene_, inlet);
      add(fmt::format("inlet {}", i), u, "m/s",
          fmt::format("{}from x = {:g} to {:g} m", umf > 0.0 ? fmt::format("{:.3g} u_mf ", u / umf) : "",
                      inlet.from, inlet.to));
    }
    const auto blocked =
        std::count_if(grid.lowestRow.begin(), grid.lowestRow.end(), [](int r) { return r > 0; });
    add("grid", fmt::format("{} x {}", grid.columns, grid.rows), "cells",
        blocked > 0 ? fmt::format("{} columns partly blocked by the distributor", blocked) : "none blocked");
    if (!grid.openCell.empty()) {
      std::size_t closed = 0;
      for (int c = 0; c < grid.columns; ++c)
        for (int r = grid.lowestRow[c]; r < grid.rows; ++r) closed += !grid.open(c, r);
      add("obstacles", static_cast<double>(closed), "cells", "of the grid blocked");
    }
  }

  static double smallestCellHeight(const GasGrid& grid) {
    double smallest = grid.dy(0);
    for (int r = 1; r < grid.rows; ++r) smallest = std::min(smallest, grid.dy(r));
    return smallest;
  }

  void sizes() {
    section_ = "sizes";
    const double particles = static_cast<double>(scene_.particles.count);
    const double cells = scene_.gas ? static_cast<double>(makeGasGrid(scene_).cells()) : 0.0;
    const double frameBytes = particles * (scene_.contacts.friction ? 20.0 : 16.0) + cells * 16.0;
    const double frames =
        std::floor(static_cast<double>(totalSteps(scene_)) / static_cast<double>(stepsPerFrame(scene_))) +
        1.0;
    add("particles", particles);
    add("frames", frames, "",
        fmt::format("one every {:g} s, {:.3g} kB each", scene_.sampling.interval, frameBytes / 1e3));
    add("trajectory", frames * frameBytes / 1e6, "MB", "before compression");
    // What a particle and a gas cell cost the solver, and the frames that wait to be written.
    add("memory", (particles * 600.0 + cells * 2000.0 + 18.0 * frameBytes) / 1e6, "MB",
        "of the solver, estimated");
  }

  /// None where steps are chosen.
  std::int64_t ticksOfGasStep() const {
    return scene_.gas && !scene_.gas->step.isAutomatic() ? stepsPerGasStep(scene_) : 0;
  }

  /// Runs the scene from a loose start for a moment and extrapolates.
  void effort() {
    section_ = "effort";
    Scene loose = scene_;
    loose.start.arrangement = Arrangement::drop;
    const int threads = threadsFor(loose.particles.count, availableCores());
    Result<Simulation> simulation = Simulation::make(loose, threads);
    if (!simulation) return add("run time", "unknown", "", toString(simulation.problems.front()));
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const std::int64_t batch = scene_.time.step.isAutomatic()
                                   ? std::llround(std::ceil(contactTimeScale(scene_) / tick(scene_)))
                                   : std::max<std::int64_t>(100, ticksOfGasStep());
    std::optional<std::string> trouble;
    do trouble = simulation->advance(batch);
    while (!trouble && elapsed() < 0.3);
    if (trouble) return add("run time", "unknown", "", *trouble);
    const double share = scene_.time.duration / simulation->time();
    add("steps", std::round(share * static_cast<double>(simulation->particleSteps())));
    add("run time", share * elapsed(), "s",
        fmt::format("measured here over {} steps from a loose start, threads: {}{}",
                    simulation->particleSteps(), threads,
                    scene_.start.arrangement == Arrangement::settled ? "; settling comes on top" : ""));
  }

  const Scene& scene_;
  std::string section_;
  std::vector<CheckRow> rows_;
};

}  // namespace

std::vector<CheckRow> effectRows(const Scene& scene) { return Report(scene).effectsOnly(); }

std::vector<CheckRow> checkReport(const Scene& scene) { return Report(scene).rows(); }

}  // namespace bedmix
