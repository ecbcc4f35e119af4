// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/painter.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bedmix {

/// What a picture shows, as the command line says it; what is empty is the scene's [pictures] or the default.
struct PictureOptions {
  std::string layers;                 // "particles,walls"
  std::string color;                  // "speed", "strips:6"
  std::string background;             // "black", "#1a2b3c"
  std::string trails;                 // "3,500"; shows the layer, too
  std::vector<std::string> settings;  // "trail_time=0.2", of [pictures]
  std::string size;                   // "1280x720"; as the bed needs it where empty
};
void addPictureOptions(CLI::App& command, PictureOptions& options);
/// The same but for the size.
void addStyleOptions(CLI::App& command, PictureOptions& options);

/// What the options ask for, checked against the scene.
Result<PaintOptions> paintOptions(const PictureOptions& options, const Scene& scene);

}  // namespace bedmix
