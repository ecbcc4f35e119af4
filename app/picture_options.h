// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/painter.h"

#include <string>

namespace CLI {
class App;
}

namespace bedmix {

/// What a picture shows, as the command line says it.
struct PictureOptions {
  std::string layers;  // "particles,walls"; empty: the default
  std::string size;    // "1280x720"; empty: as the bed needs it
};
void addPictureOptions(CLI::App& command, PictureOptions& options);

/// What the options ask for, checked against the scene.
Result<PaintOptions> paintOptions(const PictureOptions& options, const Scene& scene);

}  // namespace bedmix
