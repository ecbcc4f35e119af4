// SPDX-License-Identifier: MIT
#include "render/scales.h"

#include "engine/core/gas_grid.h"
#include "engine/core/mixing.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Of a particle in a moving bed, m/s.
double typicalSpeed(const Scene& scene) {
  const double speed = std::sqrt(scene.gravity * scene.bed.width);
  return speed > 0.0 ? speed : 1.0;
}

/// Between the coldest and the warmest that the scene begins with or lets in, which nothing leaves, K.
ColorRange temperatureRange(const Scene& scene) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  ColorRange range{heat.temperature, heat.temperature};
  const auto include = [&](double temperature) {
    range = {std::min(range.low, temperature), std::max(range.high, temperature)};
  };
  for (const auto& one : {heat.tracerTemperature, heat.wallTemperature})
    if (one) include(*one);
  if (const FeedSettings* feed = scene.effects.find<FeedSettings>())
    for (const FeedStream& stream : feed->streams) include(stream.temperature.value_or(heat.temperature));
  if (heat.gas) {
    include(heat.gas->temperature);
    include(heat.inletTemperature());
  }
  return range.high > range.low ? range : ColorRange{range.low - 1.0, range.high + 1.0};
}

}  // namespace

double meanInflow(const Scene& scene) {
  double flow = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) flow += inletVelocity(scene, inlet) * (inlet.to - inlet.from);
  return flow / scene.bed.width;
}

ColorRange colorRange(const Scene& scene, Layer field) {
  if (field == Layer::voidage) return {packedVoidage, 1.0};
  if (field == Layer::gasSpeed) {
    double speed = meanInflow(scene) / packedVoidage;
    for (const Inlet& inlet : scene.gas->inlets) speed = std::max(speed, inletVelocity(scene, inlet));
    return {0.0, speed > 0.0 ? roundUp(speed) : 1.0};
  }
  if (field == Layer::gasTemperature) return temperatureRange(scene);
  const double pressure = bedWeight(scene);
  return {0.0, pressure > 0.0 ? 2.0 * roundDown(pressure) : 1.0};
}

ColorRange colorRange(const Scene& scene, ParticleColor color) {
  if (color == ParticleColor::speed) return {0.0, roundUp(1.2 * typicalSpeed(scene))};
  if (color == ParticleColor::voidage) return colorRange(scene, Layer::voidage);
  if (color == ParticleColor::temperature) return temperatureRange(scene);
  if (color == ParticleColor::content) return {0.0, scene.effects.find<ReactionSettings>()->content};
  if (color == ParticleColor::id)
    return {0.0,
            std::max(static_cast<double>(scene.particles.count) - 1.0 + feedRate(scene) * scene.time.duration,
                     1.0)};
  if (color != ParticleColor::spin) return {};
  const double spin = roundUp(0.4 * typicalSpeed(scene) / scene.particles.diameter);
  return {-spin, spin};
}

double arrowScale(const Scene& scene, Layer arrows) {
  // A typical speed, and the length it is drawn with.
  double speed = typicalSpeed(scene), metres = 3.0 * scene.particles.diameter;
  if (arrows == Layer::gas) {
    speed = 2.0 * meanInflow(scene);
    metres = makeGasGrid(scene).dx(0);
  } else if (arrows == Layer::flow) {
    const SamplingGrid grid = samplingGrid(scene);
    metres = 0.75 * std::min(grid.width / grid.columns, grid.height / grid.rows);
  }
  if (!(speed > 0.0)) speed = 1.0;
  return metres / speed;
}

double forceScale(const Scene& scene) {
  const double force = 3.0 * bedWeight(scene) * scene.bed.thickness * scene.particles.diameter;
  return force > 0.0 ? roundUp(force) : 1.0;
}

double roundDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

double roundUp(double value) {
  const double down = roundDown(value);
  if (value <= down * (1.0 + 1e-12)) return down;
  return roundDown(2.5 * down * (1.0 + 1e-12));
}

}  // namespace bedmix
