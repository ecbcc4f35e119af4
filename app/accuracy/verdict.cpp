// SPDX-License-Identifier: MIT
#include "app/accuracy/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double goal = 0.01;
constexpr double percent = 100.0;

/// What a scene is mostly run for, of what its reference has.
const Observable* mainObservable(const Finding& reference) {
  for (const Observable& o : observables)
    if (const auto runs = reference.runs.find(o.of.name);
        o.relative && runs != reference.runs.end() && runs->second.size() >= 3)
      return &o;
  return nullptr;
}

/// Titles of what is told apart, with the risk of one false alarm shared among all that are compared.
std::string apart(const Finding& one, const Finding& other) {
  std::string titles;
  for (const Observable& o : observables) {
    const auto d = differenceOf(one, other, o, usualRisk / static_cast<double>(observables.size()));
    if (d && d->differsFromZero())
      titles += fmt::format("{}{} ({:+.2g}{})", titles.empty() ? "" : ", ", o.title,
                            (o.relative ? percent : 1.0) * d->mean, o.relative ? " %" : "");
  }
  return titles;
}

std::string forTheGoal(const Design& design, const Findings& findings, const Observable& o) {
  const Finding &reference = findings.of(design.reference), *enough = nullptr, *cheapest = nullptr;
  std::vector<double> resolved;
  const auto cheaper = [](const Finding& f, const Finding* than) {
    return f.cost && (!than || *f.cost < *than->cost);
  };
  for (const std::string& name : design.statistics) {
    const Finding& f = findings.of(name);
    const auto d = differenceOf(f, reference, o);
    if (name == design.reference || !d || !f.failure.empty()) continue;
    resolved.push_back(d->halfWidth);
    if (std::abs(d->mean) + d->halfWidth <= goal && cheaper(f, enough)) enough = &f;
    if (apart(f, reference).empty() && cheaper(f, cheapest)) cheapest = &f;
  }
  if (enough)
    return fmt::format("For 1 % in {} you need {} (cost {:.2g}).\n", o.title, enough->setting, *enough->cost);
  if (resolved.empty()) return "";
  std::string text = fmt::format(
      "1 % in {} cannot be told from noise here: half of the differences have intervals of ±{:.2g} % or "
      "more.",
      o.title, percent * median(resolved));
  // The width of an interval goes with one over the square root of the runs.
  const Finding& standard = findings.of(design.standard);
  if (const auto d = differenceOf(standard, reference, o); d && d->halfWidth > goal)
    text += fmt::format(
        " It would take about {:.0f} runs of each.",
        std::pow(d->halfWidth / goal, 2.0) * static_cast<double>(standard.runs.at(o.of.name).size()));
  if (cheapest)
    text += fmt::format(" The cheapest setting that is in nothing told apart from {} is {} (cost {:.2g}).",
                        design.reference, cheapest->setting, *cheapest->cost);
  return text + "\n";
}

std::string ofThePaper(const Design& design, const Findings& findings) {
  if (std::find(design.presets.begin(), design.presets.end(), design.paper) == design.presets.end())
    return "";
  const Finding &paper = findings.of(design.paper), &standard = findings.of(design.standard);
  if (!paper.cost || !paper.failure.empty() || !standard.failure.empty()) return "";
  const Observable* main = mainObservable(standard);
  if (!main || !differenceOf(paper, standard, *main)) return "";
  const Finding& reference = findings.of(design.reference);
  const std::string between = apart(paper, standard), gain = apart(standard, reference),
                    loss = apart(paper, reference);
  std::string text =
      fmt::format("The paper's setting ({}) costs {:.2g} x {}", design.paper, *paper.cost, design.standard);
  if (between.empty() && gain.empty()) return text + " for no measurable gain.\n";
  if (!between.empty()) text += "; the two are told apart in " + between;
  if (!gain.empty())
    text += fmt::format("; {} is told apart from {} in {}", design.standard, design.reference, gain);
  if (!loss.empty()) text += fmt::format("; the paper's from {} in {}", design.reference, loss);
  return text + ".\n";
}

/// Whether there are runs enough of both to compare anything.
bool areCompared(const Finding& one, const Finding& other) {
  return std::any_of(observables.begin(), observables.end(),
                     [&](const Observable& o) { return differenceOf(one, other, o).has_value(); });
}

std::string ofPresets(const Design& design, const Findings& findings) {
  std::string text;
  for (const std::string& name : design.presets) {
    const Finding& f = findings.of(name);
    if (name == design.reference || name == design.paper || !f.cost) continue;
    if (f.failure.empty() && !areCompared(f, findings.of(design.reference))) continue;
    const std::string bias = apart(f, findings.of(design.reference));
    text += fmt::format("{}: cost {:.2g}; ", name, *f.cost);
    text += !f.failure.empty() ? "fails.\n"
            : bias.empty()     ? "not told apart from " + design.reference + ".\n"
                               : "told apart from " + design.reference + " in " + bias + ".\n";
  }
  return text;
}

std::string forAContact(const Design& design, const Findings& findings) {
  const Finding* cheapest = nullptr;
  double least = 0.0;
  for (const Sweep& sweep : design.sweeps) {
    if (!sweep.knob.starts_with("time.")) continue;
    for (const Sweep::Turn& turn : sweep.turns) {
      const Finding& f = findings.of(turn.setting);
      const auto error = f.numbers.find(measure::worstRestitution.name),
                 wall = f.numbers.find(measure::demWall.name);
      if (error == f.numbers.end() || wall == f.numbers.end() || !f.failure.empty() || error->second > goal)
        continue;
      if (cheapest && wall->second >= least) continue;
      cheapest = &f;
      least = wall->second;
    }
  }
  return cheapest ? fmt::format("For 1 % of the speed after every single contact: {}.\n", cheapest->setting)
                  : "";
}

}  // namespace

std::string verdictOf(const Design& design, const Findings& findings) {
  std::string text;
  if (const Observable* main = mainObservable(findings.of(design.reference)))
    text += forTheGoal(design, findings, *main);
  return text + ofThePaper(design, findings) + ofPresets(design, findings) + forAContact(design, findings);
}

}  // namespace bedmix
