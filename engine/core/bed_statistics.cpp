// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"

#include "engine/core/particle_list.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bedmix {

double solidsFlux(const Frame& frame, const Scene& scene) {
  const FluxSettings& window = *scene.flux;
  const double halfWidth = scene.particles.diameter;
  const double floor = floorHeight(scene, window.x);
  const double ordinary = particleMass(scene);
  double leftward = 0.0;  // m/s, summed over as many of ordinary mass
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double x = frame.position[i].x, y = frame.position[i].y - floor;
    if (std::abs(x - window.x) <= halfWidth && y >= window.from && y <= window.to)
      leftward -= massOf(scene, frame, i) / ordinary * frame.velocity[i].x;
  }
  const double volume = 2.0 * halfWidth * (window.to - window.from) * scene.bed.thickness;
  return ordinary * leftward / volume;
}

double pressureDrop(const Frame& frame, const GasGrid& grid) {
  double sum = 0.0, width = grid.x.back() - grid.x.front();
  for (int c = 0; c < grid.columns; ++c)
    if (grid.open(c, grid.lowestRow[c]))
      sum += grid.dx(c) * static_cast<double>(frame.gas.pressure[grid.cell(c, grid.lowestRow[c])]);
    else
      width -= grid.dx(c);
  return width > 0.0 ? sum / width : 0.0;
}

double bedHeight(const Frame& frame, const Scene& scene) {
  if (frame.size() == 0) return 0.0;
  std::vector<double> height(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i)
    height[i] = frame.position[i].y - floorHeight(scene, frame.position[i].x);
  const auto at = height.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(height.size() - 1));
  std::nth_element(height.begin(), at, height.end());
  return *at + 0.5 * scene.particles.diameter;
}

namespace {

/// By mass.
std::optional<double> meanOver(const Frame& frame, const Scene& scene, const std::vector<float>& values) {
  double mass = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double m = massOf(scene, frame, i);
    mass += m;
    sum += m * static_cast<double>(values[i]);
  }
  if (!(mass > 0.0)) return std::nullopt;
  return sum / mass;
}

}  // namespace

std::optional<double> meanTemperature(const Frame& frame, const Scene& scene) {
  return meanOver(frame, scene, frame.temperature);
}
std::optional<double> meanContent(const Frame& frame, const Scene& scene) {
  return meanOver(frame, scene, frame.content);
}

double outletTemperature(const Frame& frame, const GasGrid& grid) {
  double flow = 0.0, carried = 0.0, width = 0.0, sum = 0.0;
  for (int c = 0; c < grid.columns; ++c) {
    const std::size_t cell = grid.cell(c, grid.rows - 1);
    const double up = static_cast<double>(frame.gas.voidage[cell] * frame.gas.velocity[cell].y),
                 temperature = static_cast<double>(frame.gas.temperature[cell]);
    flow += grid.dx(c) * std::max(up, 0.0);
    carried += grid.dx(c) * std::max(up, 0.0) * temperature;
    width += grid.dx(c);
    sum += grid.dx(c) * temperature;
  }
  return flow > 0.0 ? carried / flow : sum / width;
}

double particleHeat(const Frame& frame, const Scene& scene) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  double sum = 0.0;
  for (std::size_t i = 0; i < frame.size(); ++i)
    sum += massOf(scene, frame, i) * (static_cast<double>(frame.temperature[i]) - heat.temperature);
  return heat.heatCapacity * sum;
}

std::vector<std::uint8_t> tagTracer(TracerRule rule, const std::vector<Vec2f>& position,
                                    const std::vector<std::uint8_t>& kind, double width) {
  const std::size_t n = position.size();
  std::vector<std::uint8_t> tag(n);
  if (rule == TracerRule::fed) return tag;
  if (rule == TracerRule::species) {
    for (std::size_t i = 0; i < kind.size(); ++i) tag[i] = kind[i] > 0;
    return tag;
  }
  if (rule == TracerRule::leftHalf || rule == TracerRule::rightHalf) {
    for (std::size_t i = 0; i < n; ++i)
      tag[i] = (position[i].x < width / 2) == (rule == TracerRule::leftHalf);
    return tag;
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return position[a].y < position[b].y; });
  for (std::size_t k = 0; k < n; ++k) tag[order[k]] = (k < n / 2) == (rule == TracerRule::lowerHalf);
  return tag;
}

std::uint8_t tagOfFed(TracerRule rule, std::uint8_t kind) {
  return rule == TracerRule::fed || (rule == TracerRule::species && kind > 0);
}

}  // namespace bedmix
