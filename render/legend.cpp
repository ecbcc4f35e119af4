// SPDX-License-Identifier: MIT
#include "render/legend.h"

#include "engine/core/mixing.h"
#include "engine/core/particle_list.h"
#include "render/draw_bubbles.h"
#include "render/draw_fields.h"
#include "render/draw_forces.h"
#include "render/draw_particles.h"
#include "render/draw_sampling.h"
#include "render/draw_streamlines.h"
#include "render/hud_rows.h"
#include "render/scales.h"
#include "render/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace bedmix {

namespace {

constexpr float signWidth = 1.9f;    // em, room for a sign before its text
constexpr float longestSign = 1.6f;  // em

/// Writes rows one below the other.
class Column {
 public:
  Column(DrawList& list, Vec2f at, float em, const Palette& palette)
      : list_(list), at_(at), em_(em), palette_(palette) {}

  void text(std::string line, float indent = 0.0f) {
    list_.texts.push_back({at_ + Vec2f{indent * em_, 0.0f}, {0.0f, 0.0f}, palette_.ink, std::move(line)});
    at_.y += hudLine * em_;
  }
  void disc(std::string line, Rgba color) {
    list_.discs.push_back({middle(0.5f), 0.42f * em_, color});
    text(std::move(line), signWidth);
  }
  void arrow(std::string line, float length, Rgba color) {
    const float width = std::max(1.5f, 0.15f * em_);
    addArrow(list_, middle(0.08f), {length, 0.0f}, width, color);
    text(std::move(line), signWidth);
  }
  /// A line of the picture, with the rim that it has there.
  void line(std::string text_, float width, Rgba color, Rgba rim) {
    const std::size_t first = list_.lines.size();
    list_.lines.push_back({middle(0.4f), middle(1.2f), width, 0.0f, color});
    addRims(list_, first, 0.06f * em_, rim);
    text(std::move(text_), signWidth);
  }
  void hatching(std::string line) {
    const Vec2f corner = middle(0.1f);
    addHatching(list_, {corner.x, corner.y - 0.4f * em_, corner.x + 1.4f * em_, corner.y + 0.4f * em_}, em_,
                palette_.sampling);
    text(std::move(line), signWidth);
  }
  /// A title and, in the next row, `colorOf(0 to 1)` in steps between what its ends mean.
  void colorBar(std::string title, std::string low, std::string high, int steps,
                const std::function<Rgba(double)>& colorOf) {
    text(std::move(title));
    const float left = at_.x + 2.4f * em_, step = 4.0f * em_ / static_cast<float>(steps);
    const float top = at_.y + 0.15f * em_, bottom = at_.y + 0.95f * em_;
    for (int i = 0; i < steps; ++i) {
      const float x = left + static_cast<float>(i) * step;
      addRectangle(list_, {x, top}, {x + step, bottom}, colorOf((i + 0.5) / steps));
    }
    const Vec2f before{left - 0.4f * em_, at_.y}, behind{left + 4.4f * em_, at_.y};
    list_.texts.push_back({before, {1.0f, 0.0f}, palette_.ink, std::move(low)});
    list_.texts.push_back({behind, {0.0f, 0.0f}, palette_.ink, std::move(high)});
    at_.y += hudLine * em_;
  }
  void colorBar(std::string title, ColorRange range, const std::function<Rgba(double)>& colorOf) {
    colorBar(std::move(title), fmt::format("{:g}", range.low), fmt::format("{:g}", range.high), 64, colorOf);
  }

 private:
  Vec2f middle(float x) const { return at_ + Vec2f{x * em_, 0.55f * em_}; }

  DrawList& list_;
  Vec2f at_;
  float em_;
  const Palette& palette_;
};

/// Of the colours of the particles, those of bars by their unit.
void drawParticleColors(Column& column, const Scene& scene, const Style& style, const Palette& palette) {
  const ColorRange range = colorRange(scene, style.color);
  const auto disc = [&](double t) { return discColor(palette, t); };
  const auto classes = static_cast<std::size_t>(style.classes);
  const auto classOf = [&](double t) {
    return classColor(palette, static_cast<std::size_t>(t * static_cast<double>(classes)), classes);
  };
  switch (style.color) {
    case ParticleColor::tracer:
      column.disc("tracer", palette.tracer);
      return column.disc("rest", restColor);
    case ParticleColor::speed:
      return column.colorBar("speed, m/s", range, disc);
    case ParticleColor::spin:
      return column.colorBar("spin, rad/s", range, [](double t) { return coolWarm(2.0 * t - 1.0); });
    case ParticleColor::voidage:
      return column.colorBar("voidage there", range, disc);
    case ParticleColor::temperature:
      return column.colorBar("particles, K", range, warmth);
    case ParticleColor::content:
      return column.colorBar("content, kg/kg", range, disc);
    case ParticleColor::id:
      return column.colorBar("particle", range, disc);
    case ParticleColor::kind: {
      const std::vector<ParticleKind> kinds = particleKinds(scene);
      const std::size_t n = kinds.size();
      return column.colorBar("kind", std::string(kinds.front().name), std::string(kinds.back().name),
                             static_cast<int>(n), [&](double t) {
                               return classColor(
                                   palette, n - 1 - static_cast<std::size_t>(t * static_cast<double>(n)), n);
                             });
    }
    case ParticleColor::height:
      return column.colorBar("height at start", "low", "high", static_cast<int>(classes), classOf);
    case ParticleColor::strips:
      return column.colorBar("strip at start", "left", "right", static_cast<int>(classes), classOf);
  }
}

}  // namespace

int legendRows(const Style& style) {
  int rows = 0;
  for (const Layer layer : {Layer::particles, Layer::voidage, Layer::pressure, Layer::gasSpeed,
                            Layer::gasTemperature, Layer::counts})
    rows += 2 * style.layers.has(layer);
  for (const Layer layer : {Layer::bubbles, Layer::trails, Layer::forces, Layer::sampling, Layer::velocity,
                            Layer::flow, Layer::gas, Layer::streamlines})
    rows += style.layers.has(layer);
  return rows;
}

void drawLegend(DrawList& list, Vec2f at, const Scene& scene, const Style& style, const Camera& camera,
                float em) {
  const Palette palette = paletteOn(style.ground);
  Column column(list, at, em, palette);
  const auto shows = [&](Layer layer) { return style.layers.has(layer); };
  const auto arrow = [&](Layer layer, const char* what, Rgba color) {
    if (!shows(layer)) return;
    const float pxPerSpeed = camera.length(arrowScale(scene, layer));
    const double speed = roundDown(static_cast<double>(longestSign * em / pxPerSpeed));
    column.arrow(fmt::format("{} {:g} m/s", what, speed), static_cast<float>(speed) * pxPerSpeed, color);
  };
  const auto field = [&](Layer layer, const char* title) {
    if (shows(layer))
      column.colorBar(title, colorRange(scene, layer), [&](double t) { return fieldColor(layer, t); });
  };
  if (shows(Layer::particles)) drawParticleColors(column, scene, style, palette);
  if (shows(Layer::trails))
    column.line(fmt::format("last {:g} s", style.trailTime), std::max(1.5f, 0.15f * em), trailColors[0],
                palette.ground);
  arrow(Layer::velocity, "solids", velocityColor);
  arrow(Layer::flow, "mean", flowColor);
  arrow(Layer::gas, "gas", palette.gas);
  if (shows(Layer::streamlines)) column.line("gas flow", streamlineWidth(em), palette.gas, palette.ground);
  if (shows(Layer::bubbles))
    column.line(fmt::format("voidage {:g}", style.bubbleVoidage), bubbleWidth(em), bubbleColor,
                palette.ground);
  if (shows(Layer::forces)) {
    // The widest line that fits a row.
    const double widest = static_cast<double>(0.7f * em / forceWidth(scene, camera, forceScale(scene)));
    const double force = roundDown(forceScale(scene) * std::min(1.0, widest));
    column.line(fmt::format("force {:g} N", force), forceWidth(scene, camera, force), forceColor,
                palette.wall);
  }
  if (shows(Layer::sampling)) column.hatching(fmt::format("under {}", samplingGrid(scene).minParticles));
  if (shows(Layer::counts)) {
    column.text("in cells: number,");
    column.text("tracer fraction");
  }
  field(Layer::pressure, "pressure, Pa");
  field(Layer::voidage, "voidage");
  field(Layer::gasSpeed, "gas speed, m/s");
  field(Layer::gasTemperature, "gas, K");
}

}  // namespace bedmix
