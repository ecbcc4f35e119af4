// SPDX-License-Identifier: MIT
#include "replay/foreign/foreign_scene.h"

#include "engine/core/scene_reader.h"
#include "replay/file_trouble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

Result<PlaneView> viewOf(ForeignSource& source, const ForeignFrame& first, const std::string& file,
                         const ForeignOptions& options) {
  if (source.dimensions() == 2) {
    if (options.plane.value_or(ViewPlane::xy) == ViewPlane::xy) return PlaneView(ViewPlane::xy);
    return fileTrouble(file, "has two dimensions; leave out --plane");
  }
  if (options.plane) return PlaneView(*options.plane);
  if (const auto box = source.box()) return PlaneView(flattestPlane(*box));
  if (!first.position.empty()) return PlaneView(flattestPlane(boxAround(first.position)));
  return fileTrouble(file,
                     "has neither a box nor a particle in its first frame that tell in which plane its bed "
                     "lies; give --plane xy, xz or yz");
}

Result<double> diameterOf(const ForeignFrame& first, const std::string& file, const ForeignOptions& options) {
  if (options.diameter) return *options.diameter;
  if (options.scene) return options.scene->particles.diameter;
  if (!first.radius.empty()) {
    const double one = first.radius.front();  // from which equal ones differ by nothing
    double more = 0.0;
    for (const double radius : first.radius) more += radius - one;
    return 2.0 * (one + more / static_cast<double>(first.radius.size()));
  }
  return fileTrouble(file,
                     "does not tell how large its particles are; give --diameter D, in metres, or --scene");
}

/// Whether so many particles lie in it that it can be the bed's.
bool isBedOf(const PlaneBox& box, const PlaneView& view, const ForeignFrame& first) {
  const auto inside = std::count_if(first.position.begin(), first.position.end(),
                                    [&](const Vec3d& at) { return box.holds(view(at)); });
  return static_cast<double>(inside) >= 0.9 * static_cast<double>(first.position.size());
}

/// All places that particles ever have.
Result<PlaneBox> extentOf(ForeignSource& source, const PlaneView& view, const std::string& file) {
  std::optional<PlaneBox> extent;
  for (std::size_t i = 0; i < source.steps().size(); ++i) {
    const Result<ForeignFrame> frame = source.frame(i);
    if (!frame) return frame.problems;
    for (const Vec3d& position : frame->position) {
      const Vec2 at = view(position);
      if (!extent) extent = PlaneBox{at, at};
      extent->include(at);
    }
  }
  if (extent) return *extent;
  return fileTrouble(file, "has neither a box nor a particle; give --bed X0,Y0,X1,Y1");
}

Result<PlaneBox> bedOf(ForeignSource& source, const ForeignFrame& first, const PlaneView& view,
                       double diameter, const std::string& file, const ForeignOptions& options) {
  if (options.bed) return *options.bed;
  if (const auto box = source.box(); box && isBedOf(view(*box), view, first)) return view(*box);
  if (options.scene) {
    const PlaneBox bed{{0.0, 0.0}, {options.scene->bed.width, options.scene->bed.height}};
    if (isBedOf(bed, view, first)) return bed;
  }
  Result<PlaneBox> extent = extentOf(source, view, file);
  if (!extent) return extent;
  const Vec2 radius{0.5 * diameter, 0.5 * diameter};
  return PlaneBox{extent->low - radius, extent->high + radius};
}

/// Equally spaced, the last one at a whole number of intervals.
TimeSettings timesOf(const std::vector<double>& times, double interval) {
  TimeSettings time;
  time.duration = interval * std::max(1.0, std::round(times.back() / interval));
  time.step = StepLength::automatic();
  return time;
}

Scene plainScene(const std::string& file) {
  Scene scene;
  scene.name = scene.title = std::filesystem::path(file).filename().string();
  scene.contacts.restitution = 0.9;
  return scene;
}

/// As its reader takes it.
Result<Scene> checked(const Scene& scene, const std::string& file) {
  Result<Scene> read = readScene(writeScene(scene), file + ": the scene made of it");
  for (Diagnostic& problem : read.problems) problem.trouble = Trouble::file;
  if (read) read->name = scene.name;
  return read;
}

}  // namespace

Result<ForeignScene> foreignScene(ForeignSource& source, const ForeignFrame& first,
                                  const std::vector<double>& times, const std::string& file,
                                  const ForeignOptions& options) {
  const Result<PlaneView> view = viewOf(source, first, file, options);
  if (!view) return view.problems;
  const Result<double> diameter = diameterOf(first, file, options);
  if (!diameter) return diameter.problems;
  const Result<PlaneBox> bed = bedOf(source, first, *view, *diameter, file, options);
  if (!bed) return bed.problems;

  Scene scene = options.scene ? *options.scene : plainScene(file);
  if (!options.scene || options.bed) {
    scene.bed.width = bed->size().x;
    scene.bed.height = bed->size().y;
  }
  const auto box = source.box();
  if (!options.scene) scene.bed.thickness = std::max(*diameter, box ? view->depth(*box) : 0.0);
  scene.bed.top = BedTop::open;
  scene.particles.diameter = *diameter;
  scene.particles.count = static_cast<std::int64_t>(first.position.size());
  if (!first.id.empty()) scene.particles.count = std::max(scene.particles.count, first.id.back() + 1);
  scene.accuracy.reset();
  scene.gas.reset();
  scene.effects.at<HeatSettings>().reset();
  if (scene.floor.shape == FloorShape::stair) scene.floor.shape = FloorShape::straight;  // of the gas's cells
  if (first.angularVelocity.empty())
    scene.contacts.friction.reset();
  else if (!scene.contacts.friction)
    scene.contacts.friction.emplace();
  if (times.size() > 1)
    scene.sampling.interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  scene.time = timesOf(times, scene.sampling.interval);

  Result<Scene> sound = checked(scene, file);
  if (!sound) return std::move(sound.problems);
  return ForeignScene{std::move(*sound), *view, bed->low};
}

}  // namespace bedmix
