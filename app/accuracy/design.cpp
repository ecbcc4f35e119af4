// SPDX-License-Identifier: MIT
#include "app/accuracy/design.h"

#include "engine/core/presets.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace bedmix {

namespace {

constexpr double steps[] = {10.0, 20.0, 40.0, 50.0, 100.0, 200.0, 400.0};        // of T
constexpr double fineSteps = 3200.0;                                             // of T, of the reference
constexpr double gasSteps[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};  // of the scene's
constexpr double stepErrors[] = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001};            // time.error
constexpr double gasErrors[] = {0.4, 0.2, 0.1, 0.05, 0.02};
constexpr double usualSteps = 100.0,
                 usualGasSteps = 10.0;  // a scene's without lengths: of T, of the particles'
constexpr double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-6, 1e-8};
constexpr double fineTolerance = 1e-10;
constexpr double stiffnesses[] = {1.0, 2.5, 5.0, 10.0, 25.0};  // of the scene's
constexpr double grids[] = {0.5, 1.0, 2.0};                    // cells a side, of the scene's

/// Key = value lines under their tables, as writeScene() lays them out.
std::map<std::string, std::string> keysOf(const Scene& scene) {
  std::map<std::string, std::string> keys;
  std::istringstream text(writeScene(scene));
  std::string table;
  int element = -1;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("[[")) {
      const std::string list = line.substr(2, line.find(']') - 2);
      element = table.starts_with(list + '.') ? element + 1 : 0;
      table = fmt::format("{}.{}.", list, element);
    } else if (line.starts_with('[')) {
      table = line.substr(1, line.find(']') - 1) + '.';
    } else if (const std::size_t equals = line.find(" = "); equals != std::string::npos) {
      std::string value = line.substr(equals + 3, line.find("  #") - equals - 3);
      std::erase_if(value, [](char c) { return c == '"' || c == ' '; });
      keys[table + line.substr(0, equals)] = value;
    }
  }
  return keys;
}

/// A length of 1, 2, 2.5 or 5 times a power of ten that makes up `whole`, s, near `wanted`; else the next
/// equal part of it.
double partOf(double whole, double wanted) {
  double best = whole / std::max(1.0, std::round(whole / wanted)), distance = std::log(1.3);
  for (const double mantissa : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    const double part = mantissa * std::pow(10.0, std::floor(std::log10(wanted)));
    const double count = whole / part;
    if (std::round(count) < 1.0 || std::abs(count - std::round(count)) > 1e-9 * count) continue;
    if (std::abs(std::log(part / wanted)) >= distance) continue;
    distance = std::abs(std::log(part / wanted));
    best = std::stod(fmt::format("{:.3g}", part));
  }
  return best;
}

/// Spans of about `factor` times as many cells; none where a cell would be smaller than a particle.
std::optional<std::vector<GridSpan>> refined(std::vector<GridSpan> spans, double factor, double diameter) {
  for (GridSpan& s : spans) {
    const double length = static_cast<double>(s.count) * s.size;
    s.count = std::max<std::int64_t>(1, std::llround(factor * static_cast<double>(s.count)));
    s.size = length / static_cast<double>(s.count);
    if (s.size < diameter) return std::nullopt;
  }
  return spans;
}

/// What steps of particles make up, s.
double wholeOf(const Scene& scene) {
  if (scene.gas) return scene.gas->step;
  return scene.sampling.interval;
}

class Designer {
 public:
  explicit Designer(const Scene& scene) : scene_(scene), fixed_(withFixedSteps(scene)) {
    addWithStatistics(scene);
  }

  Design make() {
    presets();
    particleSteps();
    if (scene_.gas) {
      gasStep();
      tolerance();
    }
    stiffness();
    if (scene_.gas) grid();
    return std::move(design_);
  }

 private:
  std::string add(const Scene& changed) {
    std::string name = settingName(scene_, changed);
    if (std::none_of(design_.settings.begin(), design_.settings.end(),
                     [&](const Setting& s) { return s.name == name; }))
      design_.settings.push_back({name, changed});
    return name;
  }
  std::string addWithStatistics(const Scene& changed) {
    std::string name = add(changed);
    if (std::find(design_.statistics.begin(), design_.statistics.end(), name) == design_.statistics.end())
      design_.statistics.push_back(name);
    return name;
  }

  void presets() {
    Sweep sweep{"accuracy", "", "", {}};
    for (std::size_t i = 0; i < modelTable<Accuracy>.size(); ++i) {
      const std::string word(modelTable<Accuracy>[i].name), name = "accuracy=" + word;
      const auto preset = readScene(writeScene(scene_), scene_.name, accuracyOverrides(word));
      if (!preset) {
        design_.refused.push_back({name, preset.problems.front().message});
        continue;
      }
      design_.settings.push_back({name, *preset});
      design_.settings.back().scene.name = scene_.name;
      design_.statistics.push_back(name);
      design_.presets.push_back(name);
      sweep.turns.push_back({static_cast<double>(i), name});
    }
    sweep.reference = design_.reference;
    design_.sweeps.push_back(std::move(sweep));
  }

  // A gas step is a multiple of the particles' step, which so can change alone.
  double whole() const { return wholeOf(fixed_); }

  void particleSteps() {
    const double scale = contactTimeScale(fixed_);
    Scene fine = fixed_;
    fine.time.step = partOf(whole(), scale / fineSteps);
    fine.time.integrator = Integrator::verletOnset;
    const std::string reference = add(fine);
    for (std::size_t i = 0; i < modelTable<Integrator>.size(); ++i) {
      Scene changed = fixed_;
      changed.time.integrator = static_cast<Integrator>(i);
      Sweep sweep{fmt::format("time.step, {}", modelTable<Integrator>[i].name), "s", reference, {}};
      addWithStatistics(changed);
      const bool isOwn = changed.time.integrator == fixed_.time.integrator;
      for (const double n : steps) {
        const double step = partOf(whole(), scale / n);
        changed.time.step = step;
        if (sweep.turns.empty() || sweep.turns.back().value != step)
          sweep.turns.push_back({step, isOwn && n <= 50.0 ? addWithStatistics(changed) : add(changed)});
      }
      design_.sweeps.push_back(std::move(sweep));
    }
    Sweep chosen{"time.error, verlet-onset", "", reference, {}};
    for (const double error : stepErrors) {
      Scene changed = fixed_;
      changed.time.integrator = Integrator::verletOnset;
      changed.time.step = StepLength::automatic();
      changed.time.error = error;
      chosen.turns.push_back({error, add(changed)});
    }
    design_.sweeps.push_back(std::move(chosen));
  }

  void gasStep() {
    Sweep sweep{"gas.step", "s", "", {}};
    for (const double factor : gasSteps) {
      Scene changed = fixed_;
      const double wanted = factor * fixed_.gas->step, particles = fixed_.time.step;
      if (wanted > fixed_.sampling.interval * (1.0 + 1e-9)) break;
      changed.gas->step = std::max(1.0, std::round(wanted / particles)) * particles;
      changed.gas->step = std::stod(fmt::format("{:.12g}", static_cast<double>(changed.gas->step)));
      if (!sweep.turns.empty() && sweep.turns.back().value == changed.gas->step) continue;
      sweep.turns.push_back({changed.gas->step, factor >= 5.0 ? addWithStatistics(changed) : add(changed)});
    }
    sweep.reference = sweep.turns.front().setting;
    Sweep chosen{"gas.error", "", sweep.reference, {}};
    for (const double error : gasErrors) {
      Scene changed = fixed_;
      changed.gas->step = StepLength::automatic();
      changed.gas->error = error;
      chosen.turns.push_back({error, add(changed)});
    }
    design_.sweeps.push_back(std::move(sweep));
    design_.sweeps.push_back(std::move(chosen));
  }

  // Only SIMPLE repeats itself until it is within a tolerance.
  void tolerance() {
    Scene changed = fixed_;
    changed.gas->scheme = GasScheme::projection;
    addWithStatistics(changed);
    changed.gas->scheme = GasScheme::simple;
    addWithStatistics(changed);
    Sweep sweep{"gas.tolerance, simple", "", "", {}};
    changed.gas->tolerance = fineTolerance;
    sweep.reference = add(changed);
    for (const double tolerance : tolerances) {
      changed.gas->tolerance = tolerance;
      sweep.turns.push_back(
          {tolerance, tolerance == tolerances[0] ? addWithStatistics(changed) : add(changed)});
    }
    design_.sweeps.push_back(std::move(sweep));
  }

  void stiffness() {
    Sweep sweep{"contacts.stiffness", "", "", {}};
    for (const double factor : stiffnesses) {
      Scene changed = fixed_;
      if (auto& hertz = changed.contacts.hertz)
        hertz->youngsModulus *= factor;
      else
        *changed.contacts.stiffness *= factor;
      changed.time.step = partOf(whole(), fixed_.time.step / std::sqrt(factor));
      const bool runs = factor == 1.0 || factor == 5.0 || factor == 25.0;
      sweep.turns.push_back({normalStiffness(changed), runs ? addWithStatistics(changed) : add(changed)});
    }
    sweep.reference = sweep.turns.back().setting;
    design_.sweeps.push_back(std::move(sweep));
  }

  void grid() {
    Sweep sweep{"gas.grid", "", "", {}};
    for (const double factor : grids) {
      Scene changed = fixed_;
      const auto columns = refined(changed.gas->grid.columns, factor, changed.particles.diameter);
      const auto rows = refined(changed.gas->grid.rows, factor, changed.particles.diameter);
      if (!columns || !rows) continue;
      changed.gas->grid = {*columns, *rows};
      sweep.turns.push_back({factor, addWithStatistics(changed)});
    }
    sweep.reference = sweep.turns.back().setting;
    design_.sweeps.push_back(std::move(sweep));
  }

  /// Chosen steps replaced by ones of usual lengths.
  static Scene withFixedSteps(Scene scene) {
    const double step = contactTimeScale(scene) / usualSteps;
    if (scene.gas && scene.gas->step.isAutomatic())
      scene.gas->step = partOf(scene.sampling.interval, usualGasSteps * step);
    if (scene.time.step.isAutomatic()) scene.time.step = partOf(wholeOf(scene), step);
    return scene;
  }

  const Scene& scene_;
  const Scene fixed_;  // what knobs are turned from
  Design design_;
};

}  // namespace

const Setting& Design::find(std::string_view name) const {
  return *std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.name == name; });
}

bool Design::turnsContacts(std::string_view name) const {
  return std::any_of(sweeps.begin(), sweeps.end(), [&](const Sweep& sweep) {
    return (sweep.knob.starts_with("time.") || sweep.knob == "accuracy") &&
           std::any_of(sweep.turns.begin(), sweep.turns.end(),
                       [&](const Sweep::Turn& turn) { return turn.setting == name; });
  });
}

std::string settingName(const Scene& scene, const Scene& changed) {
  const auto before = keysOf(scene), after = keysOf(changed);
  std::string name;
  for (const auto& [key, value] : after)
    if (const auto old = before.find(key); old == before.end() || old->second != value)
      name += fmt::format("{}{}={}", name.empty() ? "" : " ", key, value);
  return name.empty() ? std::string(sceneItself) : name;
}

Result<Design> designFor(const Scene& scene) {
  Design design = Designer(scene).make();
  for (const Design::Refused& r : design.refused)
    for (const std::string& needed : {design.standard, design.reference})
      if (r.setting == needed) return Diagnostic{{scene.name}, r.setting + " cannot be had: " + r.why};
  return design;
}

}  // namespace bedmix
