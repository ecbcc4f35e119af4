// SPDX-License-Identifier: MIT
#include "render/draw_list.h"

#include "engine/core/gas_grid.h"
#include "engine/core/mixing.h"
#include "render/draw_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

bool outside(const Box& clip, Vec2f at, float radius) {
  return at.x + radius <= clip.left || at.x - radius >= clip.right || at.y + radius <= clip.top ||
         at.y - radius >= clip.bottom;
}

void addRectangle(DrawList& list, Vec2f a, Vec2f b, Rgba color) {
  const Vec2f c{b.x, a.y}, d{a.x, b.y};
  list.triangles.push_back({a, c, b, color});
  list.triangles.push_back({a, b, d, color});
}

/// An arrow from `tail` that is as long as `velocity`; none where it would be shorter than a pixel.
void addArrow(DrawList& list, Vec2f tail, Vec2f velocity, float pxPerSpeed, float width, Rgba color) {
  const Vec2f shift{pxPerSpeed * velocity.x, -pxPerSpeed * velocity.y};
  const float length = norm(shift);
  if (!(length >= 1.0f)) return;
  list.lines.push_back({tail, tail + shift, width, std::min(0.6f * length, 4.0f * width), color});
}

/// Puts a white rim around the last arrow, so that it shows on any ground. 2.7 rims beyond its tip are one
/// rim beside the head's slanting edges.
void addRim(DrawList& list) {
  const Line arrow = list.lines.back();
  const Vec2f along = (arrow.to - arrow.from) * (1.0f / norm(arrow.to - arrow.from));
  const float rim = 0.5f * arrow.width;
  list.lines.back() = {arrow.from, arrow.to + along * (2.7f * rim), arrow.width + 2.0f * rim,
                       arrow.head + 3.7f * rim, white};
  list.lines.push_back(arrow);
}

void drawField(DrawList& list, const Scene& scene, const std::vector<float>& field, const Camera& camera,
               ColorRange range) {
  const GasGrid grid = makeGasGrid(scene);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const double value = static_cast<double>(field[grid.cell(column, row)]);
      addRectangle(list, camera.toPixel(Vec2{grid.x[column], grid.y[row + 1]}),
                   camera.toPixel(Vec2{grid.x[column + 1], grid.y[row]}),
                   cividis((value - range.low) / (range.high - range.low)));
    }
}

/// Over a coloured field the discs get a white rim inside their edge: black would be lost on its dark end.
void drawParticles(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera, bool rim) {
  const float radius = camera.length(0.5 * scene.particles.diameter);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = camera.toPixel(frame.position[i]);
    if (outside(list.clip, at, radius)) continue;
    if (rim) list.discs.push_back({at, radius, white});
    list.discs.push_back({at, rim ? 0.8f * radius : radius, frame.species[i] == 1 ? tracerColor : restColor});
  }
}

void drawSampling(DrawList& list, const Scene& scene, const Camera& camera, float em) {
  const SamplingGrid grid = samplingGrid(scene);
  const float width = std::max(1.0f, 0.08f * em);
  for (int c = 0; c <= grid.columns; ++c) {
    const double x = grid.width * c / grid.columns;
    list.lines.push_back(
        {camera.toPixel(Vec2{x, 0.0}), camera.toPixel(Vec2{x, grid.height}), width, 0.0f, samplingColor});
  }
  for (int r = 0; r <= grid.rows; ++r) {
    const double y = grid.height * r / grid.rows;
    list.lines.push_back(
        {camera.toPixel(Vec2{0.0, y}), camera.toPixel(Vec2{grid.width, y}), width, 0.0f, samplingColor});
  }
}

void drawVelocity(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera) {
  const float pxPerSpeed = camera.length(arrowScale(scene, Layer::velocity));
  const float width = std::max(1.0f, camera.length(0.2 * scene.particles.diameter));
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = camera.toPixel(frame.position[i]);
    if (outside(list.clip, at, 0.0f)) continue;
    addArrow(list, at, frame.velocity[i], pxPerSpeed, width, velocityColor);
  }
}

void drawGas(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera) {
  const GasGrid grid = makeGasGrid(scene);
  const float pxPerSpeed = camera.length(arrowScale(scene, Layer::gas));
  const float width = std::max(1.0f, camera.length(0.1 * grid.dx(0)));
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const Vec2 centre{grid.x[column] + 0.5 * grid.dx(column), grid.y[row] + 0.5 * grid.dy(row)};
      const Vec2f velocity = frame.gas.velocity[grid.cell(column, row)];
      const Vec2f tail = camera.toPixel(centre) - Vec2f{velocity.x, -velocity.y} * (0.5f * pxPerSpeed);
      const std::size_t before = list.lines.size();
      addArrow(list, tail, velocity, pxPerSpeed, width, gasColor);
      if (list.lines.size() > before) addRim(list);
    }
}

}  // namespace

void DrawList::clear() {
  triangles.clear();
  discs.clear();
  lines.clear();
  texts.clear();
}

void drawBed(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera, const Style& style,
             float em) {
  const Layers layers = style.layers;
  if (layers.has(Layer::voidage))
    drawField(list, scene, frame.gas.voidage, camera, colorRange(scene, Layer::voidage));
  if (layers.has(Layer::pressure))
    drawField(list, scene, frame.gas.pressure, camera, colorRange(scene, Layer::pressure));
  if (layers.has(Layer::particles))
    drawParticles(list, scene, frame, camera, layers.has(Layer::voidage) || layers.has(Layer::pressure));
  if (layers.has(Layer::sampling)) drawSampling(list, scene, camera, em);
  if (layers.has(Layer::walls)) drawWalls(list, scene, camera, em);
  if (layers.has(Layer::velocity)) drawVelocity(list, scene, frame, camera);
  if (layers.has(Layer::gas)) drawGas(list, scene, frame, camera);
}

void drawScaleBar(DrawList& list, const Scene& scene, const Camera& camera, Vec2f at, float em) {
  const double metres = roundDown(scene.bed.width / 3.0);
  const float width = std::max(2.0f, 0.2f * em);
  const float y = at.y - 0.5f * em;
  const Vec2f from{at.x, y}, to{at.x + camera.length(metres), y};
  list.lines.push_back({from, to, width, 0.0f, ink});
  list.texts.push_back({{to.x + 0.5f * em, y}, {0.0f, 0.5f}, ink, fmt::format("{:g} mm", metres * 1e3)});
}

ColorRange colorRange(const Scene& scene, Layer layer) {
  if (layer == Layer::voidage) return {0.4, 1.0};
  const double weight = bedWeight(scene);
  return {0.0, weight > 0.0 ? 2.0 * roundDown(weight) : 1.0};
}

double arrowScale(const Scene& scene, Layer layer) {
  // A typical speed, and the length it is drawn with.
  double speed = std::sqrt(scene.gravity * scene.bed.width), metres = 3.0 * scene.particles.diameter;
  if (layer == Layer::gas) {
    const GasGrid grid = makeGasGrid(scene);
    double flow = 0.0;
    for (int c = 0; c < grid.columns; ++c) flow += grid.inletFlux[c] * grid.dx(c);
    speed = 2.0 * flow / scene.bed.width;
    metres = grid.dx(0);
  }
  if (!(speed > 0.0)) speed = 1.0;
  return metres / speed;
}

double roundDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

}  // namespace bedmix
