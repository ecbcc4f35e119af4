// SPDX-License-Identifier: MIT
#include "engine/core/obstacle_rules.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "engine/core/walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

constexpr double rounding = 1e-9;      // as in scene_rules.cpp
constexpr double narrowestDrum = 2.0;  // diameters, its radius
constexpr double perContact = 0.25;    // periods of a vibration in T, at most
constexpr double ofGasCell = 0.5;      // the amplitude, at most

class Rules {
 public:
  explicit Rules(const Scene& scene) : scene_(scene), diameter_(particleRange(scene).largest) {}

  std::vector<Contradiction> broken() {
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
      path_ = fmt::format("obstacles.{}", i);
      if (scene_.obstacles[i].shape == ObstacleShape::segment)
        segment(scene_.obstacles[i]);
      else
        circle(scene_.obstacles[i]);
    }
    if (scene_.floor.vibration) vibration(*scene_.floor.vibration);
    if (broken_.empty() && scene_.gas && !scene_.obstacles.empty()) inlets();
    return std::move(broken_);
  }

 private:
  void add(std::string_view key, std::vector<std::string> concerns, std::string message) {
    broken_.push_back({fmt::format("{}.{}", path_, key), std::move(message), std::move(concerns)});
  }
  void needs(std::string_view key, bool given, std::string_view shape) {
    if (!given) add(key, {path_ + ".shape"}, fmt::format("a {} needs {}", shape, key));
  }
  void hasNo(std::string_view key, bool given, std::string_view shape) {
    if (given) add(key, {path_ + ".shape"}, fmt::format("a {} has no {}; leave it out", shape, key));
  }

  void circle(const ObstacleSettings& o) {
    const std::size_t before = broken_.size();
    const std::string_view shape = modelName(o.shape);
    needs("x", o.x.has_value(), shape);
    needs("y", o.y.has_value(), shape);
    needs("radius", o.radius.has_value(), shape);
    hasNo("x1", o.x1.has_value(), shape);
    hasNo("y1", o.y1.has_value(), shape);
    hasNo("x2", o.x2.has_value(), shape);
    hasNo("y2", o.y2.has_value(), shape);
    hasNo("thickness", o.thickness.has_value(), shape);
    if (o.spinRpm && !scene_.contacts.friction)
      add("spin_rpm", {"contacts.friction"},
          "a surface that turns takes particles along by friction, and there is no [contacts.friction]");
    if (broken_.size() > before) return;
    const double x = *o.x, y = *o.y, r = *o.radius, width = scene_.bed.width, height = scene_.bed.height;
    if (o.shape == ObstacleShape::drum) return drum(o);
    if (x + r <= 0.0 || x - r >= width || y + r <= 0.0)
      add("x", {path_ + ".y", path_ + ".radius", "bed"},
          fmt::format("the circle about ({} m, {} m) lies outside the bed, which is {} m wide and {} m high",
                      x, y, width, height));
  }

  void drum(const ObstacleSettings& o) {
    const double x = *o.x, y = *o.y, r = *o.radius, width = scene_.bed.width, height = scene_.bed.height;
    if (scene_.gas) add("shape", {"gas"}, "a drum is closed, so no gas can flow through it; leave out [gas]");
    if (r < narrowestDrum * diameter_)
      add("radius", {"particles.diameter"},
          fmt::format("a drum of {} m radius is too narrow for particles of {} m; give at least {:.4g} m", r,
                      diameter_, narrowestDrum * diameter_));
    const double room = 1.0 + rounding;
    if (x - r < -rounding * r || x + r > width * room || y + r > height * room ||
        y - r < floorHeight(scene_, std::clamp(x + r, 0.0, width)) - rounding * r)
      add("radius", {path_ + ".x", path_ + ".y", "bed", "floor"},
          fmt::format("the drum reaches from ({:.4g} m, {:.4g} m) to ({:.4g} m, {:.4g} m), beyond the bed, "
                      "which is {} m wide and {} m high; the walls of the bed must stay outside it",
                      x - r, y - r, x + r, y + r, width, height));
    if (drums_++ > 0) add("shape", {}, "there can be one drum only: particles cannot be inside two");
  }

  void segment(const ObstacleSettings& o) {
    const std::size_t before = broken_.size();
    needs("x1", o.x1.has_value(), "segment");
    needs("y1", o.y1.has_value(), "segment");
    needs("x2", o.x2.has_value(), "segment");
    needs("y2", o.y2.has_value(), "segment");
    hasNo("x", o.x.has_value(), "segment");
    hasNo("y", o.y.has_value(), "segment");
    hasNo("radius", o.radius.has_value(), "segment");
    hasNo("spin_rpm", o.spinRpm.has_value(), "segment");
    if (broken_.size() > before) return;
    if (*o.x1 == *o.x2 && *o.y1 == *o.y2)
      add("x2", {path_ + ".x1", path_ + ".y1", path_ + ".y2"},
          "both ends of the segment are the same point; for a rod give a circle");
    const double width = scene_.bed.width;
    for (const auto& [key, x] : {std::pair{"x1", *o.x1}, {"x2", *o.x2}})
      if (x < -rounding * width || x > width * (1.0 + rounding))
        add(key, {"bed.width"},
            fmt::format("the segment ends at x = {} m, outside the bed, which is {} m wide", x, width));
    for (const auto& [key, y] : {std::pair{"y1", *o.y1}, {"y2", *o.y2}})
      if (y < -rounding * scene_.bed.height)
        add(key, {}, fmt::format("the segment ends at y = {} m, below the bed", y));
  }

  void vibration(const VibrationSettings& v) {
    path_ = "floor.vibration";
    const double scale = contactTimeScale(scene_);
    if (v.frequency * scale > perContact * (1.0 + rounding))
      add("frequency", {"contacts.stiffness", "particles.diameter", "particles.density"},
          fmt::format("at {} Hz the floor turns within a contact, which takes about {:.3g} s; give at most "
                      "{:.4g} Hz, or a stiffer spring",
                      v.frequency, 0.5 * scale, perContact / scale));
    if (!scene_.gas) return;
    const double cell = scene_.gas->grid.rows.empty() ? 0.0 : scene_.gas->grid.rows.front().size;
    if (v.amplitude > ofGasCell * cell * (1.0 + rounding))
      add("amplitude", {"gas.grid.rows"},
          fmt::format(
              "the gas does not know that the floor moves, so it may move by half a gas cell at most: "
              "{:.4g} m, not {} m",
              ofGasCell * cell, v.amplitude));
  }

  // Gas that enters where it cannot get out would have nowhere to go.
  void inlets() {
    const GasGrid grid = makeGasGrid(scene_);
    for (std::size_t i = 0; i < scene_.gas->inlets.size(); ++i) {
      const Inlet& in = scene_.gas->inlets[i];
      for (int c = 0; c < grid.columns; ++c) {
        if (grid.x[c + 1] <= in.from || grid.x[c] >= in.to || grid.open(c, grid.lowestRow[c])) continue;
        path_ = fmt::format("gas.inlets.{}", i);
        add("from", {"obstacles"},
            fmt::format("obstacles close the gas cell on the floor from x = {:.4g} to {:.4g} m, or every way "
                        "from there to the top, and gas enters there; move the inlet or the obstacles",
                        grid.x[c], grid.x[c + 1]));
        break;
      }
    }
  }

  const Scene& scene_;
  double diameter_;  // m
  std::string path_;
  int drums_ = 0;  // so far
  std::vector<Contradiction> broken_;
};

}  // namespace

std::vector<Contradiction> obstacleContradictions(const Scene& scene) { return Rules(scene).broken(); }

}  // namespace bedmix
