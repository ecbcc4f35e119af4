// SPDX-License-Identifier: MIT
#include "app/accuracy/diagrams.h"

#include "app/accuracy/damped_contact.h"
#include "render/diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace bedmix {

namespace {

using Style = DiagramSeries::Style;
using Value = std::function<std::optional<double>(const Finding&)>;

Value numberOf(const Measure& m) {
  return [&m](const Finding& f) -> std::optional<double> {
    const auto at = f.numbers.find(m.name);
    return at == f.numbers.end() ? std::nullopt : std::optional(at->second);
  };
}

class Diagrams {
 public:
  Diagrams(const Design& design, const Findings& findings) : design_(design), findings_(findings) {}

  std::vector<DiagramPanel> contacts() const {
    const Scene& scene = design_.settings.front().scene;
    const DampedContact pair{0.5 * particleMass(scene), normalStiffness(scene), pairDamping(scene)};
    const double seconds = pair.rebounds() ? pair.duration() : contactTimeScale(scene);
    const Value cost = [wall = numberOf(measure::demWall), seconds](const Finding& f) {
      auto w = wall(f);
      if (w) *w *= 1e9 * seconds;
      return w;
    };
    std::vector<DiagramPanel> panels;
    for (const auto& [m, title] :
         {std::pair{measure::restitution, "speed after a head-on contact, of that before"},
          std::pair{measure::oblique, "tangential impulse in full sliding, relative"}}) {
      panels.push_back(
          {title, "wall time of a particle through a contact, ns", "error, rms over phases", true, true, {}});
      addSweeps(panels.back(), cost, numberOf(m),
                [](const Sweep& s) { return turnsSteps(s) || s.knob == "accuracy"; });
    }
    return panels;
  }

  std::vector<DiagramPanel> trajectories() const {
    std::vector<DiagramPanel> panels;
    const auto add = [&](std::string title, const std::function<bool(const Sweep&)>& has) {
      panels.push_back({std::move(title),
                        "wall s per simulated s",
                        "distance from the reference, d (median)",
                        true,
                        true,
                        {}});
      addSweeps(panels.back(), cost(), nullptr, has);
    };
    add(fmt::format("steps of the particles, after {:g} s", findings_.horizon().value_or(0.0)), turnsSteps);
    add("gas: step, tolerance", [](const Sweep& s) { return turnsGas(s); });
    add("model: stiffness, grid",
        [](const Sweep& s) { return s.knob == "contacts.stiffness" || s.knob == "gas.grid"; });
    add("presets", [](const Sweep& s) { return s.knob == "accuracy"; });
    std::erase_if(panels, [](const DiagramPanel& p) { return p.series.empty(); });
    return panels;
  }

  std::vector<DiagramPanel> statistics() const {
    std::vector<DiagramPanel> panels;
    const Finding& reference = findings_.of(design_.reference);
    for (const Observable& o : observables) {
      const double scale = o.relative ? 100.0 : 1.0;
      DiagramPanel panel{std::string(o.title),
                         "wall s per simulated s",
                         o.relative ? "difference from the reference, %"
                                    : "difference from the reference" +
                                          (o.of.unit.empty() ? "" : fmt::format(", {}", o.of.unit)),
                         true,
                         false,
                         {}};
      DiagramSeries others{"other settings", Style::background, {}},
          itself{std::string(sceneItself), Style::points, {}};
      for (const std::string& name : design_.statistics) {
        const Finding& f = findings_.of(name);
        const auto d = differenceOf(f, reference, o);
        const auto x = cost()(f);
        if (!d || !x || name == design_.reference) continue;
        const DiagramPoint point{*x, scale * d->mean, scale * (d->mean - d->halfWidth),
                                 scale * (d->mean + d->halfWidth)};
        const bool isPreset =
            std::find(design_.presets.begin(), design_.presets.end(), name) != design_.presets.end();
        if (isPreset)
          panel.series.push_back({name, Style::points, {point}});
        else
          (name == sceneItself ? itself : others).points.push_back(point);
      }
      if (panel.series.empty()) continue;
      panel.series.insert(panel.series.begin(), std::move(others));
      panel.series.push_back(std::move(itself));
      panels.push_back(std::move(panel));
    }
    return panels;
  }

 private:
  static bool turnsSteps(const Sweep& s) { return s.knob.starts_with("time."); }
  static bool turnsGas(const Sweep& s) { return s.knob.starts_with("gas.") && s.knob != "gas.grid"; }

  Value cost() const {
    return [speed = findings_.standardSpeed()](const Finding& f) -> std::optional<double> {
      if (!speed || !f.cost) return std::nullopt;
      return *f.cost * *speed;
    };
  }

  /// The paper's step with the paper's integrator, whatever the rest.
  bool isPaper(const Setting& setting) const {
    if (setting.name == design_.paper) return true;
    const auto paper = std::find_if(design_.settings.begin(), design_.settings.end(),
                                    [&](const Setting& s) { return s.name == design_.paper; });
    if (paper == design_.settings.end() || setting.scene.time.step.isAutomatic()) return false;
    const double step = setting.scene.time.step, of = paper->scene.time.step;
    return setting.scene.time.integrator == paper->scene.time.integrator && std::abs(step - of) < 1e-9 * of &&
           normalStiffness(setting.scene) == normalStiffness(paper->scene);
  }

  /// A line a sweep; without `error`, of the distances from each sweep's reference.
  void addSweeps(DiagramPanel& panel, const Value& work, const Value& error,
                 const std::function<bool(const Sweep&)>& has) const {
    std::vector<double> works, errors;
    DiagramSeries itself{std::string(sceneItself), Style::marked, {}},
        paper{"the paper's", Style::marked, {}};
    for (const Sweep& sweep : design_.sweeps) {
      if (!has(sweep)) continue;
      DiagramSeries line{sweep.knob, sweep.knob == "accuracy" ? Style::points : Style::line, {}};
      for (const Sweep::Turn& turn : sweep.turns) {
        const Finding& f = findings_.of(turn.setting);
        std::optional<double> y;
        if (error)
          y = error(f);
        else if (const auto at = f.trajectories.find(sweep.reference); at != f.trajectories.end())
          y = at->second;
        const auto x = work(f);
        if (!x || !y || !f.failure.empty() || !(*y > 0.0)) continue;
        const DiagramPoint point{*x, *y, *y, *y};
        works.push_back(*x);
        errors.push_back(*y);
        line.points.push_back(point);
        if (f.setting == sceneItself) itself.points.push_back(point);
        if (isPaper(design_.find(f.setting))) paper.points.push_back(point);
      }
      if (sweep.knob == "accuracy") {  // by name
        std::size_t k = 0;
        for (const Sweep::Turn& turn : sweep.turns)
          if (k < line.points.size() && findings_.of(turn.setting).failure.empty() &&
              work(findings_.of(turn.setting)) == line.points[k].x)
            panel.series.push_back({turn.setting, Style::points, {line.points[k++]}});
      } else if (!line.points.empty()) {
        panel.series.push_back(std::move(line));
      }
    }
    if (panel.series.empty()) return;
    panel.series.push_back(std::move(itself));
    panel.series.push_back(std::move(paper));
    DiagramSeries front{"front", Style::front, {}};
    for (const std::size_t i : paretoFront(works, errors))
      front.points.push_back({works[i], errors[i], errors[i], errors[i]});
    panel.series.push_back(std::move(front));
  }

  const Design& design_;
  const Findings& findings_;
};

}  // namespace

Result<Done> drawDiagrams(const std::filesystem::path& folder, const Design& design,
                          const Findings& findings) {
  const Diagrams diagrams(design, findings);
  const std::pair<const char*, std::vector<DiagramPanel>> files[]{
      {"contacts.png", diagrams.contacts()},
      {"trajectories.png", diagrams.trajectories()},
      {"statistics.png", diagrams.statistics()}};
  for (const auto& [name, panels] : files) {
    if (panels.empty()) continue;
    if (auto drawn = writeDiagram(folder / name, panels); !drawn) return drawn;
  }
  return Done{};
}

}  // namespace bedmix
