// SPDX-License-Identifier: MIT
#include "engine/core/obstacle_rules.h"
#include "engine/core/particle_list.h"
#include "engine/core/scene_reader.h"
#include "engine/core/sides_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

using std::numbers::pi;

/// Relative difference below which two lengths or times given in decimals count as equal.
constexpr double rounding = 1e-9;

/// Whole numbers up to here are exact in a double.
constexpr double mostSteps = 1e15;

/// Frames hold places in single precision, to 6e-8 of the bed's size; that is 6 % of a diameter in a bed of
/// so many.
constexpr double mostDiameters = 1e6;

class Rules {
 public:
  explicit Rules(const Scene& scene) : scene_(scene) {}

  std::vector<Contradiction> broken() {
    addAll(contradictions(scene_, scene_.particles));
    bed();
    contacts();
    time();
    if (scene_.gas) gas(*scene_.gas);
    if (broken_.empty()) addAll(obstacleContradictions(scene_));
    if (broken_.empty()) addAll(sidesContradictions(scene_));
    if (scene_.flux) flux(*scene_.flux);
    scene_.effects.forEach([&]([[maybe_unused]] const Key& table, const auto& settings) {
      if (settings) addAll(contradictions(scene_, *settings));
    });
    if (scene_.limits.warnOverlap > scene_.limits.maxOverlap)
      add("limits.warn_overlap", {"limits.max_overlap"},
          "the warning lies above the limit that ends the run");
    if (scene_.pictures) addAll(contradictions(scene_, *scene_.pictures));
    return std::move(broken_);
  }

 private:
  void addAll(std::vector<Contradiction> more) {
    for (Contradiction& c : more) broken_.push_back(std::move(c));
  }
  void add(std::string path, std::vector<std::string> concerns, std::string message) {
    broken_.push_back({std::move(path), std::move(message), std::move(concerns)});
  }

  void bed() {
    const BedSettings& bed = scene_.bed;
    const double d = particleRange(scene_).largest;
    if (bed.thickness < d * (1.0 - rounding))
      add("bed.thickness", {"particles.diameter"},
          fmt::format("the bed is {} m thick, but its particles are {} m; give at least a diameter",
                      bed.thickness, d));
    sizeFitsFrames("bed.width", bed.width);
    sizeFitsFrames("bed.height", bed.height);
    if (bed.width < d)
      add("bed.width", {"particles.diameter"},
          fmt::format("the bed is {} m wide, narrower than a particle ({} m)", bed.width, d));

    const double rise = floorHeight(scene_, bed.width);
    if (rise + d > bed.height)
      return add(
          "floor.inclination_deg", {"bed", "particles.diameter"},
          fmt::format("the distributor rises to {:.4g} m at the right wall and leaves no room below {} m; "
                      "lower the slope or raise the bed",
                      rise, bed.height));
    if (scene_.floor.shape == FloorShape::stair && scene_.floor.inclinationDeg > 0.0 && !scene_.gas)
      add("floor.shape", {"gas"},
          "a stair is made of the gas grid's blocked cells, and there is no [gas]; "
          "use \"straight\"");
    if (bed.top != BedTop::lid) return;
    const double area = bed.width * (bed.height - 0.5 * rise);
    const double room = std::floor(pi / (2.0 * std::sqrt(3.0)) * area / (0.25 * pi * d * d));
    if (static_cast<double>(scene_.particles.count) > room)
      add("particles.count", {"bed", "floor", "particles.diameter"},
          fmt::format(
              "{} particles do not fit under the lid: even the closest packing holds {:.0f}; take fewer, "
              "a taller bed or top = \"open\"",
              scene_.particles.count, room));
  }

  void sizeFitsFrames(const std::string& path, double size) {
    const double diameters = size / particleRange(scene_).smallest;
    if (diameters > mostDiameters)
      add(path, {"particles.diameter"},
          fmt::format("{} is {:.3g} particle diameters; frames are precise enough for a bed of {:g}, so take "
                      "a smaller bed or larger particles",
                      path, diameters, mostDiameters));
  }

  void contacts() {
    const ContactSettings& c = scene_.contacts;
    if (c.restitution && c.damping)
      add("contacts.damping", {"contacts.restitution"},
          fmt::format("restitution and damping both set the dashpot: {} and {} kg/s contradict each other or "
                      "repeat each other; keep one",
                      *c.restitution, *c.damping));
    if (c.hertz && c.stiffness)
      add("contacts.stiffness", {"contacts.hertz"},
          "stiffness is that of linear springs, and [contacts.hertz] replaces them; keep one");
    if (c.hertz && c.damping)
      add("contacts.damping", {"contacts.hertz"},
          "a Hertzian contact's dashpot follows from restitution; give that instead of damping");
    if (c.rolling && !c.friction)
      add("contacts.rolling", {"contacts.friction"},
          "particles without friction do not rotate, so that there is no rolling to resist; give "
          "[contacts.friction]");
    if (c.rolling && c.rolling->model == RollingModel::elasticPlastic)
      needsVerlet("contacts.rolling.model", "the spring of elastic-plastic rolling");
    if (!c.restitution && !c.damping)
      add("contacts.restitution", {"contacts.damping"},
          "[contacts] needs either restitution (rebound over approach speed) or damping (kg/s)");
  }

  void needsVerlet(std::string path, std::string_view what) {
    if (scene_.time.integrator != Integrator::rk4) return;
    add(std::move(path), {"time.integrator"},
        fmt::format("{} is not among what time.integrator = \"rk4\" advances; take another integrator",
                    what));
  }

  void time() {
    const TimeSettings& t = scene_.time;
    if (t.step.isAutomatic()) return chosenStep();
    const double scale = contactTimeScale(scene_), step = t.step;
    if (step > longestStep(scene_) * (1.0 + rounding))
      add("time.step", {"contacts.stiffness", "particles.diameter", "particles.density"},
          fmt::format("a step of {} s is T/{:.3g} of the contact time scale T = 2 pi sqrt(m/k) = {:.4g} s; "
                      "contacts are resolved from T/14 on, and a bed over-compacts at T/10. "
                      "Take at most {:.3g} s, or a softer spring",
                      step, scale / step, scale, longestStep(scene_)));
    wholeMultiple("time.duration", t.duration, "time.step", step);
    wholeMultiple("sampling.interval", scene_.sampling.interval, "time.step", step);
    if (scene_.gas && !scene_.gas->step.isAutomatic())
      wholeMultiple("gas.step", scene_.gas->step, "time.step", step);
  }

  // Steps are cut where a run ends and where a gas step does; on its way a run that is to be gone on with
  // must not be cut elsewhere.
  void chosenStep() {
    if (scene_.time.integrator == Integrator::symplecticEuler)
      add("time.integrator", {"time.step"},
          "symplectic Euler's errors cancel over a contact as long as steps are equal, and chosen ones are "
          "not; take another integrator or give time.step");
    const double interval = scene_.sampling.interval;
    if (!scene_.gas || scene_.gas->step.isAutomatic()) {
      if (areCountable("time.duration", scene_.time.duration, "sampling.interval", tick(scene_)))
        wholeMultiple("time.duration", scene_.time.duration, "sampling.interval", interval);
    } else {
      wholeMultiple("time.duration", scene_.time.duration, "gas.step", scene_.gas->step);
      wholeMultiple("sampling.interval", interval, "gas.step", scene_.gas->step);
    }
  }

  bool areCountable(const std::string& path, double value, const std::string& ofPath, double step) {
    const double steps = value / step;
    if (steps <= mostSteps) return true;
    add(path, {ofPath},
        fmt::format("{} = {} s takes {:.3g} steps of {} s; at most {:g} can be counted", path, value, steps,
                    step, mostSteps));
    return false;
  }

  void wholeMultiple(const std::string& path, double value, const std::string& ofPath, double of) {
    if (!areCountable(path, value, ofPath, of)) return;
    const double ratio = value / of;
    const double whole = std::max(1.0, std::round(ratio));
    if (std::abs(ratio - whole) <= rounding * whole) return;
    add(path, {ofPath},
        fmt::format(
            "{} = {} s is {:.6g} steps of {} s, but must be a whole number of them; the nearest is {:.9g} s",
            path, value, ratio, of, whole * of));
  }

  void gas(const GasSettings& gas) {
    spansFill("gas.grid.columns", gas.grid.columns, "bed.width", scene_.bed.width);
    spansFill("gas.grid.rows", gas.grid.rows, "bed.height", scene_.bed.height);
    exchange(gas);
    for (std::size_t i = 0; i < gas.inlets.size(); ++i) inlet(gas, i);
  }

  // See longestGasStep(). Stopping the gas takes a pressure, too, that changes the particles' own velocity by
  // (1-e)/e v times the densities' ratio; that may not be more than twice v either.
  void exchange(const GasSettings& gas) {
    const ParticleSettings& p = scene_.particles;
    if (p.count == 0) return;
    const double relaxation = packedRelaxation(scene_), longest = longestGasStep(scene_);
    if (!gas.step.isAutomatic() && gas.step > longest * (1.0 + rounding))
      add("gas.step", {"particles.diameter", "particles.density", "gas.viscosity"},
          fmt::format(
              "a gas step of {} s is too long for particles that in a packed bed follow the gas within "
              "{:.3g} s: "
              "gas and particles would overshoot each other more with every step. Take at most {:.3g} s",
              static_cast<double>(gas.step), relaxation, longest));
    if (scene_.effects.find<VirtualMassSettings>()) return;  // which sees to that itself
    const double lightest = gas.density * (1.0 - packedVoidage) / (2.0 * packedVoidage);
    const std::vector<ParticleKind> kinds = particleKinds(scene_);
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (kinds[k].density < lightest * (1.0 - rounding))
        add(k == 0 ? "particles.density" : fmt::format("particles.species.{}.density", k - 1),
            {"gas.density"},
            fmt::format(
                "particles of {} kg/m3 are too light for a gas of {} kg/m3: gas and particles would "
                "overshoot each other more with every step. Give at least {:.4g} kg/m3, or [virtual_mass]",
                kinds[k].density, gas.density, lightest));
  }

  void spansFill(const std::string& path, const std::vector<GridSpan>& spans, const std::string& ofPath,
                 double length) {
    double sum = 0.0;
    for (const GridSpan& s : spans) sum += static_cast<double>(s.count) * s.size;
    if (std::abs(sum - length) > rounding * length)
      add(path, {ofPath},
          fmt::format("the cells add up to {:.9g} m, but {} is {:.9g} m", sum, ofPath, length));
    const double d = particleRange(scene_).largest;
    for (const GridSpan& s : spans)
      if (mostParticles(scene_) > 0 && s.size < d)
        add(path, {"particles.diameter"},
            fmt::format(
                "cells of {} m are smaller than a particle ({} m); volume-averaged gas needs cells of at "
                "least a diameter, better three",
                s.size, d));
  }

  void inlet(const GasSettings& gas, std::size_t index) {
    const Inlet& in = gas.inlets[index];
    const std::string path = fmt::format("gas.inlets.{}", index);
    if (in.from >= in.to)
      return add(path + ".to", {path + ".from"},
                 fmt::format("the inlet ends at {} m, not right of where it begins ({} m)", in.to, in.from));
    if (in.to > scene_.bed.width * (1.0 + rounding))
      add(path + ".to", {"bed.width"},
          fmt::format("the inlet ends at {} m, outside the floor, which is {} m wide", in.to,
                      scene_.bed.width));
    for (std::size_t other = 0; other < index; ++other) {
      const Inlet& o = gas.inlets[other];
      if (std::min(in.to, o.to) - std::max(in.from, o.from) <= rounding * scene_.bed.width) continue;
      add(path, {fmt::format("gas.inlets.{}", other)},
          fmt::format("the inlet from {} to {} m overlaps the one from {} to {} m", in.from, in.to, o.from,
                      o.to));
      break;
    }
    if (in.velocity && in.velocityUmf)
      add(path + ".velocity_umf", {path + ".velocity"},
          "velocity and velocity_umf both set the inlet's velocity; keep one");
    if (!in.velocity && !in.velocityUmf)
      add(path + ".velocity", {path + ".velocity_umf"},
          "the inlet needs either velocity (m/s) or velocity_umf (multiples of u_mf)");
    for (std::size_t k = 1; k < in.schedule.size(); ++k)
      if (in.schedule[k].time <= in.schedule[k - 1].time)
        add(fmt::format("{}.schedule.{}.time", path, k), {fmt::format("{}.schedule.{}.time", path, k - 1)},
            fmt::format("the schedule goes from {} s to {} s; its points must follow each other in time",
                        in.schedule[k - 1].time, in.schedule[k].time));
    if (in.pulse && !gas.step.isAutomatic() && gas.step > 0.1 / in.pulse->frequency)
      add(path + ".pulse.frequency", {"gas.step"},
          fmt::format("gas steps of {} s do not tell pulses of {} Hz; take steps of at most a tenth of a "
                      "period, {:.3g} s",
                      static_cast<double>(gas.step), in.pulse->frequency, 0.1 / in.pulse->frequency));
    const bool hasOwnUmf = gas.minimumFluidizationVelocity.has_value();
    const bool rises = scene_.particles.density <= gas.density || scene_.gravity <= 0.0;
    if (in.velocityUmf && !hasOwnUmf && rises)
      add(path + ".velocity_umf", {"particles.density", "gas.density", "gravity"},
          "particles that do not sink in the gas have no minimum fluidization velocity; give velocity in "
          "m/s");
  }

  void flux(const FluxSettings& window) {
    const double d = scene_.particles.diameter, width = scene_.bed.width;
    if (window.from >= window.to)
      add("flux.to", {"flux.from"},
          fmt::format("the window ends at {} m, not above where it begins ({} m)", window.to, window.from));
    if (window.x - d < 0.0 || window.x + d > width)
      add("flux.x", {"bed.width", "particles.diameter"},
          fmt::format("the strip of a diameter to either side of x = {} m leaves the bed, which is {} m wide",
                      window.x, width));
    const double floor = floorHeight(scene_, window.x);
    if (floor + window.to > scene_.bed.height * (1.0 + rounding))
      add("flux.to", {"flux.x", "bed", "floor"},
          fmt::format("the window reaches {:.4g} m (the floor there is at {:.4g} m), above the bed's {} m",
                      floor + window.to, floor, scene_.bed.height));
  }

  const Scene& scene_;
  std::vector<Contradiction> broken_;
};

}  // namespace

std::vector<Contradiction> contradictions(const Scene& scene) { return Rules(scene).broken(); }

}  // namespace bedmix
