// SPDX-License-Identifier: MIT
#include "app/recording_options.h"

#include "app/scene_library.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace bedmix {

void addRecordingOptions(CLI::App& command, RecordingOptions& options) {
  const char* const group = "Files of other programs";
  command
      .add_option("--scene", options.scene,
                  "Scene with the bed, particles, sampling and window; made from the file by default")
      ->type_name("SCENE")
      ->group(group);
  command
      .add_option("--plane", options.plane,
                  "Plane the bed lies in; by default without the thinnest direction")
      ->type_name("xy|xz|yz")
      ->check(CLI::IsMember(std::vector<std::string>(planeNames.begin(), planeNames.end())))
      ->group(group);
  command.add_option("--bed", options.bed, "Edges of the bed in that plane, m; the file's box by default")
      ->type_name("X0,Y0,X1,Y1")
      ->delimiter(',')
      ->expected(4)
      ->group(group);
  command
      .add_option("--diameter", options.diameter, "Diameter of the particles, m; the file's mean by default")
      ->type_name("D")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command
      .add_option("--time-step", options.timeStep,
                  "Length of a step, s, where the file numbers its steps only")
      ->type_name("DT")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_option("--group", options.group, "Group of the particles in an H5MD file; all by default")
      ->type_name("NAME")
      ->group(group);
  command
      .add_option(
          "--tracer-species", options.tracerSpecies,
          "Species that is the tracer; by default the larger of two, with one only the left half at the "
          "first frame")
      ->type_name("N")
      ->group(group);
}

Result<ForeignOptions> foreignOptions(const RecordingOptions& options) {
  ForeignOptions foreign;
  foreign.group = options.group;
  foreign.diameter = options.diameter;
  foreign.timeStep = options.timeStep;
  foreign.tracerSpecies = options.tracerSpecies;
  if (!options.plane.empty()) {
    const auto* const name = std::find(planeNames.begin(), planeNames.end(), options.plane);
    foreign.plane = static_cast<ViewPlane>(name - planeNames.begin());
  }
  if (!options.bed.empty()) {
    foreign.bed = PlaneBox{{options.bed[0], options.bed[1]}, {options.bed[2], options.bed[3]}};
    const Vec2 size = foreign.bed->size();
    if (!(size.x > 0.0 && size.y > 0.0))
      return Diagnostic{{"--bed"}, "the second corner must lie above and to the right of the first"};
  }
  if (!options.scene.empty()) {
    Result<Scene> scene = loadScene(options.scene);
    if (!scene) return std::move(scene.problems);
    foreign.scene = std::move(*scene);
  }
  return foreign;
}

}  // namespace bedmix
