// SPDX-License-Identifier: MIT
#include "tests/render/bed.h"

#include "engine/core/gas_grid.h"

#include <algorithm>
#include <cmath>

namespace bedmix::test {

namespace {

void add(Frame& frame, Vec2f position, Vec2f velocity, bool tracer) {
  frame.position.push_back(position);
  frame.velocity.push_back(velocity);
  frame.species.push_back(tracer ? 1 : 0);
  frame.id.push_back(static_cast<std::int32_t>(frame.id.size()));
}

GasFrame movingGas(const Scene& scene) {
  constexpr double surface = 0.25, weight = 1284.0;
  const GasGrid grid = makeGasGrid(scene);
  GasFrame gas{std::vector<float>(grid.cells(), 1.0f), std::vector<float>(grid.cells()),
               std::vector<Vec2f>(grid.cells())};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const double x = grid.x[column] + 0.5 * grid.dx(column), y = grid.y[row] + 0.5 * grid.dy(row);
      const double fromBubble = std::hypot(x - 0.05, y - 0.12);
      const double voidage = y > surface ? 1.0 : 0.45 + 0.5 * std::exp(-std::pow(fromBubble / 0.03, 2));
      const std::size_t cell = grid.cell(column, row);
      gas.voidage[cell] = static_cast<float>(voidage);
      gas.pressure[cell] = static_cast<float>(std::max(0.0, weight * (1.0 - y / surface)));
      gas.velocity[cell] = toFloat({0.4 * std::sin(40.0 * y), 2.58 / voidage});
    }
  return gas;
}

}  // namespace

Scene flatBed() {
  Scene scene;
  scene.name = "flat";
  scene.contacts.restitution = 0.9;
  scene.gas.emplace();
  scene.gas->grid = {{{8, 0.012}}, {{15, 0.012}, {12, 0.020}}};
  scene.gas->inlets = {{0.0, 0.096, std::nullopt, 2.0}};
  return scene;
}

Scene inclinedBed() {
  Scene scene = flatBed();
  scene.name = "inclined";
  scene.floor.inclinationDeg = 18.0;
  scene.gas->inlets = {{0.0, 0.024, std::nullopt, 5.0}, {0.072, 0.096, std::nullopt, 3.0}};
  return scene;
}

Scene gaslessBed() {
  Scene scene = flatBed();
  scene.name = "gasless";
  scene.gas.reset();
  return scene;
}

Frame movingFrame(const Scene& scene, double time) {
  const double pitch = 1.25 * scene.particles.diameter, radius = 0.5 * scene.particles.diameter;
  const auto wanted = static_cast<std::size_t>(scene.particles.count);
  Frame frame;
  frame.time = time;
  for (int row = 0; frame.size() < wanted; ++row)
    for (double x = radius + (row % 2) * 0.5 * pitch; x <= scene.bed.width - radius && frame.size() < wanted;
         x += pitch) {
      const double y = floorHeight(scene, x) + radius + row * pitch * std::sqrt(0.75);
      const Vec2 velocity{8.0 * (y - 0.1), -15.0 * (x - 0.5 * scene.bed.width)};
      add(frame, toFloat({x, y}), toFloat(velocity), frame.size() % 3 == 0);
    }
  if (scene.contacts.friction)
    for (const Vec2f& p : frame.position) frame.angularVelocity.push_back(2000.0f * (p.x - 0.05f));
  if (scene.gas) frame.gas = movingGas(scene);
  return frame;
}

Frame particlesAt(std::initializer_list<Vec2f> black, std::initializer_list<Vec2f> green, double time) {
  Frame frame;
  frame.time = time;
  for (const Vec2f& at : black) add(frame, at, {}, true);
  for (const Vec2f& at : green) add(frame, at, {}, false);
  return frame;
}

}  // namespace bedmix::test
