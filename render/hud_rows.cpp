// SPDX-License-Identifier: MIT
#include "render/hud_rows.h"

#include "engine/core/mixing.h"
#include "render/draw_bed.h"
#include "render/legend.h"
#include "render/scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bedmix {

namespace {

std::string indexText(const char* name, std::optional<double> value) {
  return value ? fmt::format("{} {:.2f}", name, *value) : fmt::format("{} -", name);
}

void drawState(DrawList& list, Vec2f at, float em, const Scene& scene, const Frame& frame, Rgba color,
               const std::string& name) {
  const auto row = [&](std::string text) {
    list.texts.push_back({at, {0.0f, 0.0f}, color, std::move(text)});
    at.y += hudLine * em;
  };
  if (!name.empty()) row(name);
  row(timeLabel(frame.time, timeDecimals(std::array{scene.sampling.interval})));
  row(fmt::format("{} particles", frame.size()));
  if (scene.gas) row(fmt::format("u = {:.1f} u_mf", meanInflow(scene) / minimumFluidizationVelocity(scene)));
  const MixingSample mixing = mixingSample(frame, samplingGrid(scene));
  row(indexText("Lacey", mixing.lacey));
  row(indexText("Ashton", mixing.ashton));
}

}  // namespace

HudRowCount hudRowCount(const Scene& scene, const Style& style, bool isNamed) {
  return {(scene.gas ? 5 : 4) + isNamed, legendRows(style)};
}

void drawHud(DrawList& list, const Scene& scene, const Frame& frame, const Style& style, const Layout& layout,
             const std::string& name) {
  const Palette palette = paletteOn(style.ground);
  drawState(list, layout.state, layout.em, scene, frame, palette.ink, name);
  drawLegend(list, layout.legend, scene, style, layout.camera, layout.em);
  drawScaleBar(list, scene, layout.camera, layout.scaleBar, layout.em, palette.ink);

  const double top = layout.camera.heightAt(layout.view.top);
  const auto above = std::count_if(frame.position.begin(), frame.position.end(),
                                   [&](Vec2f p) { return static_cast<double>(p.y) > top; });
  if (above > 0) {
    const float middle = layout.camera.toPixel(Vec2{0.5 * scene.bed.width, 0.0}).x;
    list.texts.push_back({{middle, layout.view.top + 0.2f * layout.em},
                          {0.5f, 0.0f},
                          palette.ink,
                          fmt::format("{} above", above)});
  }
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
