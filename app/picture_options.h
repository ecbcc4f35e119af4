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

/// How beds are drawn, as the command line says it; what is empty is the scene's [pictures] or the default.
struct StyleOptions {
  std::string layers;                 // "particles,walls"
  std::string color;                  // "speed", "strips:6"
  std::string background;             // "black", "#1a2b3c"
  std::vector<std::string> settings;  // "trail_time=0.2", of [pictures]
};
void addStyleOptions(CLI::App& command, StyleOptions& options);
/// What the options ask for, checked against the scene.
Result<Style> styleFor(const StyleOptions& options, const Scene& scene);

/// What a picture of its own shows.
struct PictureOptions : StyleOptions {
  std::string trails;  // "3,500"; shows the layer, too
  std::string size;    // "1280x720"; as the bed needs it where empty
};
void addPictureOptions(CLI::App& command, PictureOptions& options);
Result<PaintOptions> paintOptions(const PictureOptions& options, const Scene& scene);

}  // namespace bedmix
