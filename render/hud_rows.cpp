// SPDX-License-Identifier: MIT
#include "render/hud_rows.h"

#include "engine/core/mixing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bedmix {

namespace {

constexpr float signWidth = 1.9f;    // em, room for a sign of the legend before its text
constexpr float longestSign = 1.6f;  // em

/// Writes rows one below the other.
class Column {
 public:
  Column(DrawList& list, Vec2f at, float em) : list_(list), at_(at), em_(em) {}

  void text(std::string line, float indent = 0.0f) {
    list_.texts.push_back({at_ + Vec2f{indent * em_, 0.0f}, {0.0f, 0.0f}, ink, std::move(line)});
    at_.y += hudLine * em_;
  }
  void disc(std::string line, Rgba color) {
    list_.discs.push_back({middle(0.5f), 0.42f * em_, color});
    text(std::move(line), signWidth);
  }
  void arrow(std::string line, float length, Rgba color) {
    const float width = std::max(1.5f, 0.15f * em_);
    list_.lines.push_back({middle(0.08f), middle(0.08f) + Vec2f{length, 0.0f}, width,
                           std::min(0.6f * length, 4.0f * width), color});
    text(std::move(line), signWidth);
  }
  /// A title and, in the next row, the map's colours between the ends of the range.
  void colorBar(std::string title, ColorRange range) {
    text(std::move(title));
    constexpr int steps = 64;
    const float left = at_.x + 2.0f * em_, step = 4.0f * em_ / steps;
    const float top = at_.y + 0.15f * em_, bottom = at_.y + 0.95f * em_;
    for (int i = 0; i < steps; ++i) {
      const Vec2f a{left + static_cast<float>(i) * step, top}, b{a.x + step, bottom};
      const Rgba color = cividis((i + 0.5) / steps);
      list_.triangles.push_back({a, {b.x, a.y}, b, color});
      list_.triangles.push_back({a, b, {a.x, b.y}, color});
    }
    const Vec2f end{left + 4.0f * em_ + 0.4f * em_, at_.y};
    list_.texts.push_back({{left - 0.4f * em_, at_.y}, {1.0f, 0.0f}, ink, fmt::format("{:g}", range.low)});
    list_.texts.push_back({end, {0.0f, 0.0f}, ink, fmt::format("{:g}", range.high)});
    at_.y += hudLine * em_;
  }

 private:
  Vec2f middle(float x) const { return at_ + Vec2f{x * em_, 0.55f * em_}; }

  DrawList& list_;
  Vec2f at_;
  float em_;
};

std::string indexText(const char* name, std::optional<double> value) {
  return value ? fmt::format("{} {:.2f}", name, *value) : fmt::format("{} -", name);
}

/// Superficial velocity over the bed's whole cross section, m/s.
double supply(const Scene& scene) {
  double flow = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) flow += inletVelocity(scene, inlet) * (inlet.to - inlet.from);
  return flow / scene.bed.width;
}

void drawState(Column column, const Scene& scene, const Frame& frame, const std::string& name) {
  if (!name.empty()) column.text(name);
  column.text(timeLabel(frame.time, timeDecimals(std::array{scene.sampling.interval})));
  column.text(fmt::format("{} particles", frame.size()));
  if (scene.gas)
    column.text(fmt::format("u = {:.1f} u_mf", supply(scene) / minimumFluidizationVelocity(scene)));
  const MixingSample mixing = mixingSample(frame, samplingGrid(scene));
  column.text(indexText("Lacey", mixing.lacey));
  column.text(indexText("Ashton", mixing.ashton));
}

void drawLegend(Column column, const Scene& scene, Layers layers, const Camera& camera, float em) {
  const auto arrow = [&](Layer layer, const char* what, Rgba color) {
    const float pxPerSpeed = camera.length(arrowScale(scene, layer));
    const double speed = roundDown(static_cast<double>(longestSign * em / pxPerSpeed));
    column.arrow(fmt::format("{} {:g} m/s", what, speed), static_cast<float>(speed) * pxPerSpeed, color);
  };
  if (layers.has(Layer::particles)) {
    column.disc("tracer", tracerColor);
    column.disc("rest", restColor);
  }
  if (layers.has(Layer::velocity)) arrow(Layer::velocity, "solids", velocityColor);
  if (layers.has(Layer::gas)) arrow(Layer::gas, "gas", gasColor);
  if (layers.has(Layer::pressure)) column.colorBar("pressure, Pa", colorRange(scene, Layer::pressure));
  if (layers.has(Layer::voidage)) column.colorBar("voidage", colorRange(scene, Layer::voidage));
}

}  // namespace

HudRowCount hudRowCount(const Scene& scene, Layers layers, bool isNamed) {
  HudRowCount rows;
  rows.state = (scene.gas ? 5 : 4) + isNamed;
  rows.legend =
      2 * (layers.has(Layer::particles) + layers.has(Layer::pressure) + layers.has(Layer::voidage)) +
      layers.has(Layer::velocity) + layers.has(Layer::gas);
  return rows;
}

void drawHud(DrawList& list, const Scene& scene, const Frame& frame, Layers layers, const Layout& layout,
             const std::string& name) {
  drawState({list, layout.state, layout.em}, scene, frame, name);
  drawLegend({list, layout.legend, layout.em}, scene, layers, layout.camera, layout.em);
  drawScaleBar(list, scene, layout.camera, layout.scaleBar, layout.em);

  const double top = layout.camera.heightAt(layout.view.top);
  const auto above = std::count_if(frame.position.begin(), frame.position.end(),
                                   [&](Vec2f p) { return static_cast<double>(p.y) > top; });
  if (above > 0) {
    const float middle = layout.camera.toPixel(Vec2{0.5 * scene.bed.width, 0.0}).x;
    list.texts.push_back(
        {{middle, layout.view.top + 0.2f * layout.em}, {0.5f, 0.0f}, ink, fmt::format("{} above", above)});
  }
}

void drawLegend(DrawList& list, const Scene& scene, Layers layers, const Camera& camera, Vec2f at, float em) {
  drawLegend({list, at, em}, scene, layers, camera, em);
}

std::string timeLabel(double time, int decimals) { return fmt::format("t = {:.{}f} s", time, decimals); }

int timeDecimals(std::span<const double> times) {
  int decimals = 1;
  double unit = 10.0;
  const auto whole = [&](double time) {
    return std::abs(unit * time - std::round(unit * time)) < 1e-6 * unit;
  };
  for (; decimals < 6 && !std::all_of(times.begin(), times.end(), whole); ++decimals) unit *= 10.0;
  return decimals;
}

}  // namespace bedmix
