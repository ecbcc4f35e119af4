// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "replay/foreign/foreign_source.h"
#include "replay/foreign/plane_view.h"

#include <cstdint>
#include <optional>
#include <string>

namespace bedmix {

/// What a user says of a file of another program.
struct ForeignOptions {
  std::optional<Scene> scene;                 // its bed, particles, sampling, window, pictures
  std::optional<ViewPlane> plane;             // the one that is thinnest where it is not given
  std::string group;                          // of particles, of H5MD; all where it is empty
  std::optional<double> diameter;             // m; the mean of the first frame's
  std::optional<double> timeStep;             // s; in place of the file's times
  std::optional<PlaneBox> bed;                // in the plane, in the file's coordinates
  std::optional<std::int64_t> tracerSpecies;  // by the file's own number
};

/// A scene that a file may have been made with, and where it lies.
struct ForeignScene {
  Scene scene;
  PlaneView view;
  Vec2 corner;  // m: the bed's lower left one, in the plane, in the file's coordinates
};

/// Makes the scene of a file at these times, whose first frame, in order of id, this is. It is the one of the
/// options without its gas, or a plain one; in either count, times and friction (there where particles
/// rotate) are the file's. The count is at least the largest id and one more, as pictures expect. Size and
/// corner of the bed are the options'; else the size is that of the options' scene, else both are those of
/// the file's box, or else of the options' scene, if nine of ten particles lie in it, else of all places that
/// particles ever have, and a radius around: then, and only then, all frames are read. The particles' density
/// and contacts of a plain scene mean nothing. Fails where the diameter is not known, and where the scene is
/// none that the reader of scenes takes.
Result<ForeignScene> foreignScene(ForeignSource& source, const ForeignFrame& first,
                                  const std::vector<double>& times, const std::string& file,
                                  const ForeignOptions& options);

}  // namespace bedmix
