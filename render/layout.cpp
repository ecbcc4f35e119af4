// SPDX-License-Identifier: MIT
#include "render/layout.h"

#include "render/draw_walls.h"
#include "render/hud_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

namespace {

// In em.
constexpr float margin = 0.7f;        // around everything
constexpr float panelWidth = 11.5f;   // the HUD beside the bed
constexpr float columnWidth = 9.5f;   // a column of the HUD above the bed
constexpr float scaleBarBand = 1.6f;  // below the bed
// Of the picture's width or height.
constexpr float smallestChart = 0.3f, largestChart = 0.7f, chartStep = 0.05f;
constexpr float narrowestChart = 14.0f, lowestChart = 12.0f;  // em
constexpr float highestChart = 0.9f;                          // of its width

float scaleIn(const Scene& scene, const Box& room) {
  return std::min(room.width() / static_cast<float>(scene.bed.width),
                  room.height() / static_cast<float>(viewHeight(scene)));
}

/// One bed in its part of a picture, no larger than `widest`, px per m.
Layout layoutBed(const Scene& scene, const Box& part, const Style& style, bool isNamed, float em,
                 float widest = std::numeric_limits<float>::infinity()) {
  const float width = part.width(), height = part.height();
  Layout layout;
  layout.em = em;
  const float edge = margin * em;
  const bool hud = style.layers.has(Layer::hud);

  float below = edge;
  if (style.layers.has(Layer::walls)) below += inletArrowHeight(scene, em);
  if (hud) below += scaleBarBand * em;
  const Box full{edge, edge, width - edge, std::max(height - below, 0.5f * height)};

  const HudRowCount rows = hudRowCount(scene, style, isNamed);
  Box room = full;
  bool beside = false;
  if (hud) {
    Box underHud = full, besideHud = full;
    underHud.top += (hudLine * static_cast<float>(std::max(rows.state, rows.legend)) + 0.3f) * em;
    underHud.top = std::min(underHud.top, 0.5f * full.bottom);  // in a tiny picture the HUD gives way
    besideHud.left += panelWidth * em;
    beside = scaleIn(scene, besideHud) > scaleIn(scene, underHud);
    room = beside ? besideHud : underHud;
  }
  layout.camera.scale = std::min(widest, scaleIn(scene, room));

  const float panel = beside ? panelWidth * em : 0.0f;
  const float left = 0.5f * (width - panel - layout.camera.length(scene.bed.width));  // both are centred
  layout.camera.origin = {left + panel, room.bottom};
  layout.view = {beside ? left + panel - edge : 0.0f, hud && !beside ? room.top : 0.0f, width, height};
  const float stateHeight = hudLine * static_cast<float>(rows.state + 1) * em;
  layout.state = beside ? Vec2f{left, edge} : Vec2f{std::max(edge, 0.5f * width - columnWidth * em), edge};
  layout.legend = layout.state + (beside ? Vec2f{0.0f, stateHeight} : Vec2f{columnWidth * em, 0.0f});
  layout.scaleBar = {layout.camera.origin.x, height - 0.5f * edge};

  const Vec2f corner{part.left, part.top};
  for (Vec2f* at : {&layout.camera.origin, &layout.state, &layout.legend, &layout.scaleBar})
    *at = *at + corner;
  Box& view = layout.view;
  view = {view.left + corner.x, view.top + corner.y, view.right + corner.x, view.bottom + corner.y};
  return layout;
}

/// Beds in equal columns of `part`.
std::vector<Layout> layoutBeds(std::span<const Scene> scenes, const Box& part, const Style& style, float em) {
  const bool areNamed = scenes.size() > 1;
  std::vector<Layout> beds;
  float scale = std::numeric_limits<float>::infinity();
  for (int round = 0; round < 2; ++round) {  // the second one to the scale that fits all
    beds.clear();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto edge = [&](std::size_t n) {
        return std::round(part.left +
                          part.width() * static_cast<float>(n) / static_cast<float>(scenes.size()));
      };
      beds.push_back(
          layoutBed(scenes[i], {edge(i), part.top, edge(i + 1), part.bottom}, style, areNamed, em, scale));
    }
    for (const Layout& bed : beds) scale = std::min(scale, bed.camera.scale);
  }
  return beds;
}

float textHeight(float width, float height) {
  return std::clamp(std::round(std::min(width / 20.0f, height / 36.0f)), 8.0f, 128.0f);
}

PictureLayout layoutWithChart(std::span<const Scene> scenes, const Box& beds, const Box& chart,
                              const Style& style, float em) {
  PictureLayout layout;
  layout.em = em;
  layout.beds = layoutBeds(scenes, beds, style, layout.em);
  const float edge = margin * layout.em;
  layout.chart = {chart.left + edge, chart.top + edge, chart.right - edge, chart.bottom - edge};
  const float tallest = highestChart * layout.chart.width();
  const float spare = std::max(0.0f, layout.chart.height() - tallest);
  layout.chart.top += 0.5f * spare;
  layout.chart.bottom -= 0.5f * spare;
  return layout;
}

}  // namespace

Box wholeOf(Size size) {
  return {0.0f, 0.0f, static_cast<float>(size.width), static_cast<float>(size.height)};
}

PictureLayout layoutPicture(std::span<const Scene> scenes, const Box& whole, const Style& style) {
  if (!style.layers.has(Layer::curve)) {
    const float em = textHeight(whole.width() / static_cast<float>(scenes.size()), whole.height());
    return {layoutBeds(scenes, whole, style, em), {}, em};
  }
  const auto scale = [](const PictureLayout& layout) { return layout.beds.front().camera.scale; };
  // Beds and chart share the width.
  const float share = std::max(1.8f, static_cast<float>(scenes.size()));
  const float em = textHeight(whole.width() / share, whole.height());
  PictureLayout best;
  for (const bool isBeside : {true, false})
    for (float part = smallestChart; part < largestChart; part += chartStep) {
      Box beds = whole, chart = whole;
      if (isBeside)
        beds.right = chart.left = std::round(whole.left + (1.0f - part) * whole.width());
      else
        beds.bottom = chart.top = std::round(whole.top + (1.0f - part) * whole.height());
      PictureLayout layout = layoutWithChart(scenes, beds, chart, style, em);
      const bool isReadable = layout.chart.width() >= narrowestChart * layout.em &&
                              layout.chart.height() >= lowestChart * layout.em;
      // The larger chart, where it costs the beds nothing.
      if (best.beds.empty() || (isReadable && scale(layout) >= scale(best))) best = std::move(layout);
    }
  return best;
}

Layout layoutPicture(const Scene& scene, Size size, const Style& style) {
  return layoutPicture(std::span(&scene, 1), wholeOf(size), style).beds.front();
}

double viewHeight(const Scene& scene) {
  return scene.bed.top == BedTop::open ? 1.1 * scene.bed.height : scene.bed.height;
}

}  // namespace bedmix
