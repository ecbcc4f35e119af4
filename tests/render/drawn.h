// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix::test {

inline constexpr float em = 10.0f;
inline constexpr Camera camera{{100.0f, 900.0f}, 2000.0f};  // 2 px per mm

/// The draw list of a bed seen by the camera, in a picture of 400 x 1000 px.
inline DrawList drawn(const Scene& scene, const Frame& frame, const Style& style,
                      const History& history = {}) {
  DrawList list;
  list.clip = {0.0f, 0.0f, 400.0f, 1000.0f};
  drawBed(list, scene, frame, camera, style, em, history);
  return list;
}

/// A place in the picture back in metres.
inline Vec2 metres(Vec2f px) {
  return {static_cast<double>((px.x - camera.origin.x) / camera.scale),
          static_cast<double>((camera.origin.y - px.y) / camera.scale)};
}

}  // namespace bedmix::test
