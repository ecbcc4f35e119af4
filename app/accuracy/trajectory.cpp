// SPDX-License-Identifier: MIT
#include "app/accuracy/trajectory.h"

#include "app/accuracy/line_fit.h"
#include "app/accuracy/scene_steps.h"
#include "app/accuracy/start_states.h"
#include "engine/core/rng.h"
#include "engine/simulation.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace bedmix {

namespace {

constexpr double nudge = 1e-6;                  // diameters
constexpr double fitFrom = 3e-6, fitTo = 1e-2;  // diameters
constexpr double predictableTo = 0.1;           // diameters
constexpr int looks = 200;

double rootMeanSquare(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

std::vector<double> distances(const Frame& a, const Frame& b, double diameter) {
  std::vector<double> apart;
  for (std::size_t i = 0; i < a.size(); ++i)
    apart.push_back(std::hypot(static_cast<double>(a.position[i].x) - b.position[i].x,
                               static_cast<double>(a.position[i].y) - b.position[i].y) /
                    diameter);
  return apart;
}

Result<Divergence> measureDivergence(const Scene& scene, const Particles& start, double longest) {
  Particles moved = start;
  Rng rng(1);
  for (Vec2& p : moved.position) {
    const double angle = 2.0 * std::numbers::pi * rng.uniform();
    p += nudge * scene.particles.diameter * Vec2{std::cos(angle), std::sin(angle)};
  }
  Simulation one = Simulation::make(scene, start), other = Simulation::make(scene, std::move(moved));
  const std::int64_t chunk = ticksIn(scene, longest / looks);
  std::vector<double> times, logs;
  for (int look = 0; look < looks; ++look) {
    for (Simulation* twin : {&one, &other})
      if (auto trouble = twin->advance(chunk)) return Diagnostic{{scene.name}, *trouble};
    const double apart = rootMeanSquare(distances(*one.frame(), *other.frame(), scene.particles.diameter));
    if (apart > fitTo) break;
    if (apart < fitFrom) continue;
    times.push_back(one.time());
    logs.push_back(std::log(apart));
  }
  Divergence divergence{0.0, std::numeric_limits<double>::infinity()};
  if (times.size() < 3) return divergence;
  divergence.growth = std::max(0.0, fitLine(times, logs).slope);
  if (divergence.growth > 0.0) divergence.predictable = std::log(predictableTo / nudge) / divergence.growth;
  return divergence;
}

Result<FramePtr> frameAt(const Scene& scene, const Particles& start, double horizon) {
  Simulation simulation = Simulation::make(scene, start);
  if (auto trouble = simulation.advance(ticksIn(scene, horizon))) return Diagnostic{{scene.name}, *trouble};
  return simulation.frame();
}

}  // namespace bedmix
