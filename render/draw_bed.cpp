// SPDX-License-Identifier: MIT
#include "render/draw_bed.h"

#include "render/draw_arrows.h"
#include "render/draw_bubbles.h"
#include "render/draw_fields.h"
#include "render/draw_forces.h"
#include "render/draw_particles.h"
#include "render/draw_sampling.h"
#include "render/draw_streamlines.h"
#include "render/draw_walls.h"
#include "render/scales.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

void drawBed(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera, const Style& style,
             float em, const History& history) {
  const Palette palette = paletteOn(style.ground);
  const BedView view{scene, frame, camera, style, palette, em};
  const auto shows = [&](Layer layer) { return style.layers.has(layer); };
  for (const Layer field : {Layer::voidage, Layer::pressure, Layer::gasSpeed})
    if (shows(field)) drawField(list, view, field);
  if (shows(Layer::bubbles)) drawBubbles(list, view);
  if (shows(Layer::particles)) drawParticles(list, view, history);
  if (shows(Layer::trails)) drawTrails(list, view, history);
  if (shows(Layer::forces)) drawForces(list, view);
  if (shows(Layer::sampling)) drawSampling(list, view);
  if (shows(Layer::counts)) drawCounts(list, view);
  if (shows(Layer::walls)) drawWalls(list, scene, camera, em, palette, frame.time);
  if (shows(Layer::velocity)) drawVelocity(list, view);
  if (shows(Layer::flow)) drawFlow(list, view);
  if (shows(Layer::gas)) drawGas(list, view);
  if (shows(Layer::streamlines)) drawStreamlines(list, view);
}

void drawScaleBar(DrawList& list, const Scene& scene, const Camera& camera, Vec2f at, float em, Rgba color) {
  const double metres = roundDown(scene.bed.width / 3.0);
  const float width = std::max(2.0f, 0.2f * em);
  const float y = at.y - 0.5f * em;
  const Vec2f from{at.x, y}, to{at.x + camera.length(metres), y};
  list.lines.push_back({from, to, width, 0.0f, color});
  list.texts.push_back({{to.x + 0.5f * em, y}, {0.0f, 0.5f}, color, fmt::format("{:g} mm", metres * 1e3)});
}

}  // namespace bedmix
