// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/camera.h"
#include "render/colors.h"
#include "render/history.h"
#include "render/style.h"

#include <string>
#include <vector>

namespace bedmix {

struct Triangle {
  Vec2f a, b, c;  // px
  Rgba color;
};
struct Disc {
  Vec2f at;             // px
  float radius = 0.0f;  // px
  Rgba color;
};
/// Round ends; with a head, an arrow to `to` whose head is that long.
struct Line {
  Vec2f from, to;      // px
  float width = 1.0f;  // px
  float head = 0.0f;   // px
  Rgba color;
};
/// `anchor` says which point of the text lies at `at`: {0, 0} its top left, {1, 1} its bottom right corner.
struct Text {
  Vec2f at;  // px
  Vec2f anchor;
  Rgba color;
  std::string text;
};

/// What is to be drawn, in pixels and without any OpenGL: triangles, then discs, lines and texts, each kind
/// in its order. Nothing but texts shows outside `clip`.
struct DrawList {
  Box clip;
  std::vector<Triangle> triangles;
  std::vector<Disc> discs;
  std::vector<Line> lines;
  std::vector<Text> texts;

  /// Empties it and keeps the memory.
  void clear();
};

/// Appends the bed's layers (all but HUD and curve) as the camera sees them. Line widths follow `em`, the
/// height of the picture's text, px. Discs that lie wholly outside `list.clip` are left out. A layer of the
/// gas needs a frame with gas, trails and colours of the start need a history that has seen the frame.
void drawBed(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera, const Style& style,
             float em, const History& history = {});

/// Appends a scale bar of a round length and its label, its left end and lower edge at `at`.
void drawScaleBar(DrawList& list, const Scene& scene, const Camera& camera, Vec2f at, float em);

/// Range of the colours of a layer, pressure (Pa, 0 to somewhat more than the bed's weight per area) or
/// voidage (packed to empty); fixed for a scene so that frames compare.
struct ColorRange {
  double low = 0.0;
  double high = 1.0;
};
ColorRange colorRange(const Scene& scene, Layer layer);

/// How long the arrows of the particles or the gas are in the bed: metres per m/s, fixed for a scene.
double arrowScale(const Scene& scene, Layer velocityOrGas);

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
double roundDown(double value);

}  // namespace bedmix
