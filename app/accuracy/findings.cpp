// SPDX-License-Identifier: MIT
#include "app/accuracy/findings.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double rounding = 1e-6;  // of errors, which are taken from frames and their floats
constexpr double small = 0.03;     // errors above are no longer in proportion to a power of the step

std::optional<double> valueOf(const Sample& sample, const Measure& m) {
  const auto at = sample.values.find(m.name);
  return at == sample.values.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace

std::optional<Estimate> differenceOf(const Finding& one, const Finding& other, const Observable& observable,
                                     double risk) {
  const auto a = one.runs.find(observable.of.name), b = other.runs.find(observable.of.name);
  if (a == one.runs.end() || b == other.runs.end()) return std::nullopt;
  auto found = difference(a->second, b->second, risk);
  if (!found || !observable.relative) return found;
  const double mean = estimate(b->second)->mean;
  if (mean == 0.0) return std::nullopt;
  found->mean /= mean;
  found->halfWidth /= std::abs(mean);
  return found;
}

Findings::Findings(const Design& design, const std::vector<Sample>& samples, double duration) {
  std::map<std::string, std::map<std::string, std::vector<double>>> trajectories;
  std::map<std::string, std::map<std::string_view, std::vector<double>>> numbers;
  std::map<std::string, std::vector<double>> costs;
  std::vector<double> walls, growths;
  for (const Setting& s : design.settings) findings_.push_back({s.name, {}, {}, {}, {}, {}, {}});
  for (const Sample& s : samples) {
    const auto finding = std::find_if(findings_.begin(), findings_.end(),
                                      [&](const Finding& f) { return f.setting == s.key.setting; });
    if (finding == findings_.end()) continue;
    std::string& failure = s.key.panel == Panel::drift ? finding->boxFailure : finding->failure;
    if (failure.empty()) failure = s.failure;
    switch (s.key.panel) {
      case Panel::timing:
        if (!s.failure.empty()) break;
        costs[s.key.setting].push_back(*valueOf(s, measure::wall) / *valueOf(s, measure::standardWall));
        if (s.key.setting == design.standard)
          walls.push_back(*valueOf(s, measure::standardWall) / *valueOf(s, measure::simulated));
        [[fallthrough]];
      case Panel::contact:
      case Panel::drift:
        for (const auto& [name, value] : s.values) numbers[s.key.setting][name].push_back(value);
        break;
      case Panel::divergence:
        if (const auto growth = valueOf(s, measure::growth)) growths.push_back(*growth);
        break;
      case Panel::trajectory:
        if (const auto error = valueOf(s, measure::position))
          trajectories[s.key.setting][s.key.reference].push_back(*error);
        if (const auto horizon = valueOf(s, measure::horizon)) horizon_ = horizon;
        break;
      case Panel::statistics:
        if (s.failure.empty() && std::abs(*valueOf(s, measure::simulated) - duration) < 1e-6 * duration)
          for (const auto& [name, value] : s.values) finding->runs[name].push_back(value);
        break;
    }
  }
  for (Finding& f : findings_) {
    if (const auto cost = costs.find(f.setting); cost != costs.end()) f.cost = median(cost->second);
    for (const auto& [name, values] : numbers[f.setting]) f.numbers[name] = median(values);
    for (const auto& [reference, values] : trajectories[f.setting])
      f.trajectories[reference] = median(values);
  }
  if (!walls.empty()) wall_ = median(walls);
  if (!growths.empty()) growth_ = median(growths);
  fitOrders(design);
}

const Finding& Findings::of(std::string_view setting) const {
  return *std::find_if(findings_.begin(), findings_.end(),
                       [&](const Finding& f) { return f.setting == setting; });
}

void Findings::fitOrders(const Design& design) {
  for (const Sweep& sweep : design.sweeps) {
    if (sweep.unit.empty()) continue;
    const auto fit = [&](std::string_view what, auto&& errorOf) {
      std::vector<double> steps, errors;
      for (const Sweep::Turn& turn : sweep.turns)
        if (const std::optional<double> error = errorOf(of(turn.setting))) {
          steps.push_back(turn.value);
          errors.push_back(*error);
        }
      orders_.push_back({sweep.knob, what, fitOrder(steps, errors, rounding, small)});
    };
    const auto number = [](const Measure& m) {
      return [&m](const Finding& f) {
        const auto at = f.numbers.find(m.name);
        return at == f.numbers.end() ? std::nullopt : std::optional(at->second);
      };
    };
    if (sweep.knob.starts_with("time.")) {
      fit("within a contact", number(measure::interior));
      fit("a whole contact", number(measure::restitution));
    }
    fit("trajectories", [&](const Finding& f) {
      const auto at = f.trajectories.find(sweep.reference);
      return at == f.trajectories.end() ? std::nullopt : std::optional(at->second);
    });
  }
}

}  // namespace bedmix
