// SPDX-License-Identifier: MIT
#include "render/layout.h"

#include "render/draw_walls.h"
#include "render/hud_rows.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// In em.
constexpr float margin = 0.7f;        // around everything
constexpr float panelWidth = 11.5f;   // the HUD beside the bed
constexpr float columnWidth = 9.5f;   // a column of the HUD above the bed
constexpr float scaleBarBand = 1.6f;  // below the bed

float scaleIn(const Scene& scene, const Box& room) {
  return std::min(room.width() / static_cast<float>(scene.bed.width),
                  room.height() / static_cast<float>(viewHeight(scene)));
}

}  // namespace

double viewHeight(const Scene& scene) {
  return scene.bed.top == BedTop::open ? 1.1 * scene.bed.height : scene.bed.height;
}

Layout layoutPicture(const Scene& scene, Size size, const Style& style) {
  const Layers layers = style.layers;
  const float width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  Layout layout;
  layout.em = std::clamp(std::round(std::min(width / 20.0f, height / 36.0f)), 8.0f, 128.0f);
  const float em = layout.em, edge = margin * em;
  const bool hud = layers.has(Layer::hud);

  float below = edge;
  if (layers.has(Layer::walls)) below += inletArrowHeight(scene, em);
  if (hud) below += scaleBarBand * em;
  const Box full{edge, edge, width - edge, std::max(height - below, 0.5f * height)};

  const HudRowCount rows = hudRowCount(scene, style);
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
  layout.camera.scale = scaleIn(scene, room);

  const float panel = beside ? panelWidth * em : 0.0f;
  const float left = 0.5f * (width - panel - layout.camera.length(scene.bed.width));  // both are centred
  layout.camera.origin = {left + panel, room.bottom};
  layout.view = {beside ? left + panel - edge : 0.0f, hud && !beside ? room.top : 0.0f, width, height};
  const float stateHeight = hudLine * static_cast<float>(rows.state + 1) * em;
  layout.state = beside ? Vec2f{left, edge} : Vec2f{std::max(edge, 0.5f * width - columnWidth * em), edge};
  layout.legend = layout.state + (beside ? Vec2f{0.0f, stateHeight} : Vec2f{columnWidth * em, 0.0f});
  layout.scaleBar = {layout.camera.origin.x, height - 0.5f * edge};
  return layout;
}

}  // namespace bedmix
