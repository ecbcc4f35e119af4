// SPDX-License-Identifier: MIT
#pragma once

#include "app/version.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/png.h"

#include <fmt/core.h>

namespace bedmix {

/// Where a picture comes from, for its tEXt: no clock, so the same picture gives the same bytes.
inline PngText pngText(const Scene& scene) {
  return {{"Title", scene.title},
          {"Software", fmt::format("bedmix {} ({})", programVersion, programCommit)},
          {"Source", fmt::format("scene {}, seed {}", scene.name, scene.seed)}};
}
/// The same of one frame.
inline PngText withFrame(PngText text, const Frame& frame) {
  text.emplace_back("Description", fmt::format("step {}, {} s", frame.step, frame.time));
  return text;
}

}  // namespace bedmix
