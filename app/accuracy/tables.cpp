// SPDX-License-Identifier: MIT
#include "app/accuracy/tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

namespace {

constexpr double percent = 100.0;

std::string number(const Finding& f, const Measure& m) {
  const auto at = f.numbers.find(m.name);
  return at == f.numbers.end() ? "" : fmt::format("{:.2g}", at->second);
}

std::string costOf(const Finding& f) { return f.cost ? fmt::format("{:.3g}", *f.cost) : ""; }

/// Rows of texts under headings, the first column left, the others right. A row of one text is a heading
/// across all.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> headings) { add(std::move(headings)); }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  std::string text() const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
      for (std::size_t c = 0; c < row.size() && row.size() > 1; ++c)
        widths[c] = std::max(widths[c], lengthOf(row[c]));
    std::string text;
    for (const auto& row : rows_) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        const std::string space(row.size() > 1 ? widths[c] - lengthOf(row[c]) : 0, ' ');
        text += c == 0 ? row[c] + space : "  " + space + row[c];
      }
      text.erase(text.find_last_not_of(' ') + 1);
      text += '\n';
    }
    return text;
  }

 private:
  static std::size_t lengthOf(const std::string& utf8) {
    return static_cast<std::size_t>(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
  }
  std::vector<std::vector<std::string>> rows_;
};

std::string numerics(const Design& design, const Findings& findings) {
  TextTable table({"setting", "cost", "rebound", "sliding", "drift", "trajectory"});
  for (const Sweep& sweep : design.sweeps) {
    table.add({fmt::format("{}; trajectories beside {}", sweep.knob, sweep.reference)});
    for (const Sweep::Turn& turn : sweep.turns) {
      const Finding& f = findings.of(turn.setting);
      std::string trajectory;
      if (const auto at = f.trajectories.find(sweep.reference); at != f.trajectories.end())
        trajectory = fmt::format("{:.2g}", at->second);
      table.add({"  " + f.setting, costOf(f), number(f, measure::restitution), number(f, measure::oblique),
                 f.boxFailure.empty() ? number(f, measure::drift) : "unstable",
                 f.failure.empty() ? trajectory : "fails, see below"});
    }
  }
  return table.text();
}

std::string statistics(const Design& design, const Findings& findings) {
  const Finding& reference = findings.of(design.reference);
  std::vector<const Observable*> shown;
  std::vector<std::string> headings{"setting", "cost", "runs"};
  for (const Observable& o : observables)
    if (const auto runs = reference.runs.find(o.of.name);
        runs != reference.runs.end() && runs->second.size() >= 3) {
      shown.push_back(&o);
      const std::string_view unit = o.relative ? "%" : o.of.unit;
      headings.push_back(std::string(o.title) + (unit.empty() ? "" : fmt::format(", {}", unit)));
    }
  if (shown.empty()) return "";
  TextTable table(headings);
  int compared = 0, apart = 0;
  for (const std::string& name : design.statistics) {
    const Finding& f = findings.of(name);
    const auto runs = f.runs.find(measure::simulated.name);
    if (runs == f.runs.end()) continue;
    std::vector<std::string> row{name, costOf(f), std::to_string(runs->second.size())};
    for (const Observable* o : shown) {
      if (name == design.reference) {
        const auto own = estimate(reference.runs.at(o->of.name));
        row.push_back(fmt::format("{:.4g} ±{:.2g}", own->mean, own->halfWidth));
      } else if (const auto d = differenceOf(f, reference, *o)) {
        const double scale = o->relative ? percent : 1.0;
        row.push_back(fmt::format("{}{:+.2g} ±{:.2g}", d->differsFromZero() ? "* " : "", scale * d->mean,
                                  scale * d->halfWidth));
        ++compared;
        apart += d->differsFromZero();
      } else {
        row.emplace_back();
      }
    }
    table.add(std::move(row));
  }
  return fmt::format(
      "\nStatistics: differences from {} (whose own row has its means), with 95 % intervals.\n{}"
      "* told apart from the reference: {} of {} comparisons, where chance alone makes 1 in 20.\n",
      design.reference, table.text(), apart, compared);
}

std::string orders(const Findings& findings) {
  TextTable table({"order of the error in", "of", "order", "points"});
  for (const FittedOrder& o : findings.orders())
    table.add({o.knob, std::string(o.of),
               o.order ? fmt::format("{:.2f} ±{:.2f}", o.order->value, o.order->uncertainty) : "not resolved",
               o.order ? std::to_string(o.order->points) : ""});
  return "\n" + table.text();
}

std::string failures(const Design& design, const Findings& findings) {
  std::string text;
  for (const Design::Refused& r : design.refused)
    text += fmt::format("\nrefused: {}\n  {}", r.setting, r.why);
  for (const Finding& f : findings.all()) {
    if (!f.failure.empty()) text += fmt::format("\nfails: {}\n  {}", f.setting, f.failure);
    if (!f.boxFailure.empty())
      text += fmt::format("\nunstable in an elastic box: {}\n  {}", f.setting, f.boxFailure);
  }
  return text.empty() ? text : text + "\n";
}

std::string conservation(const Findings& findings) {
  double residual = -1.0, loose = 0.0;
  for (const Finding& f : findings.all()) {
    const auto worst = [&](const Measure& m, double& into) {
      if (const auto runs = f.runs.find(m.name); runs != f.runs.end())
        for (const double v : runs->second) into = std::max(into, v);
    };
    worst(measure::massResidual, residual);
    worst(measure::notConverged, loose);
  }
  if (residual < 0.0) return "";
  return fmt::format(
      "\nConservation: no cell of the gas lacked more than {:.2g} of the inflow in any run; at most {:.2g} "
      "of a run's gas "
      "steps met the iteration limit.\n",
      residual, loose);
}

}  // namespace

std::string tablesOf(const Design& design, const Findings& findings) {
  std::string text = "cost: wall time over that of " + design.standard;
  if (const auto wall = findings.standardSpeed()) text += fmt::format(" ({:.3g} s per simulated s)", *wall);
  text +=
      "; rebound, sliding: errors of single contacts against closed forms;\ndrift: energy of an elastic box; "
      "trajectory: ";
  if (const auto horizon = findings.horizon())
    text += fmt::format("distance of half of the particles from the reference's after {:g} s, diameters",
                        *horizon);
  if (const auto growth = findings.growth(); growth && *growth > 0.0)
    text += fmt::format(" (twin runs part e-fold in {:.2g} s)", 1.0 / *growth);
  return text + "\n\n" + numerics(design, findings) + orders(findings) + statistics(design, findings) +
         conservation(findings) + failures(design, findings);
}

}  // namespace bedmix
