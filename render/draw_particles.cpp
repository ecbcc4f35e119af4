// SPDX-License-Identifier: MIT
#include "render/draw_particles.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "render/scales.h"
#include "render/shapes.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Index of the stretch between `faces` that holds `at`; of the first or last one beyond them.
std::size_t stretchOf(const std::vector<double>& faces, float at) {
  const auto above = std::upper_bound(faces.begin() + 1, faces.end() - 1, static_cast<double>(at));
  return static_cast<std::size_t>(above - faces.begin()) - 1;
}

/// Appends a disc a particle, coloured by `colorOf(row)`.
template <class ColorOf>
void addDiscs(DrawList& list, const BedView& view, const ColorOf& colorOf) {
  const Layers layers = view.style.layers;
  const bool rim =
      std::any_of(fieldLayers.begin(), fieldLayers.end(), [&](Layer l) { return layers.has(l); });
  const float ofAll = view.camera.length(0.5 * view.scene.particles.diameter);
  const std::vector<float>& radii = view.frame.radius;
  const bool repeats = view.scene.bed.sides == BedSides::periodic;
  const float left = view.camera.toPixel(Vec2{0.0, 0.0}).x, width = view.camera.length(view.scene.bed.width);
  for (std::size_t i = 0; i < view.frame.size(); ++i) {
    const float radius = radii.empty() ? ofAll : view.camera.length(static_cast<double>(radii[i]));
    const auto add = [&](Vec2f at) {
      if (isOutside(list.clip, at, radius)) return;
      if (rim) list.discs.push_back({at, radius, view.palette.ground});
      list.discs.push_back({at, rim ? 0.8f * radius : radius, colorOf(i)});
    };
    const Vec2f at = view.camera.toPixel(view.frame.position[i]);
    add(at);
    if (!repeats) continue;
    // Who hangs over one side comes in at the other.
    if (at.x - radius < left) add({at.x + width, at.y});
    if (at.x + radius > left + width) add({at.x - width, at.y});
  }
}

}  // namespace

Rgba discColor(const Palette& palette, double t) {
  return cividis(palette.lowest + std::clamp(t, 0.0, 1.0) * (palette.highest - palette.lowest));
}

Rgba classColor(const Palette& palette, std::size_t index, std::size_t classes) {
  if (classes == 2) return index == 0 ? palette.tracer : restColor;
  return discColor(palette,
                   classes > 1 ? static_cast<double>(index) / static_cast<double>(classes - 1) : 0.0);
}

void drawParticles(DrawList& list, const BedView& view, const History& history) {
  const Frame& frame = view.frame;
  const ParticleColor color = view.style.color;
  const ColorRange range = colorRange(view.scene, color);
  const auto mapped = [&](auto value) {
    return discColor(view.palette, range.share(static_cast<double>(value)));
  };
  switch (color) {
    case ParticleColor::tracer:
      return addDiscs(list, view,
                      [&](std::size_t i) { return frame.species[i] == 1 ? view.palette.tracer : restColor; });
    case ParticleColor::speed:
      return addDiscs(list, view, [&](std::size_t i) { return mapped(norm(frame.velocity[i])); });
    case ParticleColor::spin:
      return addDiscs(list, view, [&](std::size_t i) {
        return coolWarm(static_cast<double>(frame.angularVelocity[i]) / range.high);
      });
    case ParticleColor::voidage: {
      const GasGrid grid = makeGasGrid(view.scene);
      return addDiscs(list, view, [&](std::size_t i) {
        const Vec2f at = frame.position[i];
        const std::size_t column = stretchOf(grid.x, at.x), row = stretchOf(grid.y, at.y);
        return mapped(frame.gas.voidage[row * static_cast<std::size_t>(grid.columns) + column]);
      });
    }
    case ParticleColor::kind: {
      const std::size_t kinds = particleKinds(view.scene).size();
      return addDiscs(list, view, [&](std::size_t i) {
        return classColor(view.palette, kinds - 1 - (frame.kind.empty() ? 0 : frame.kind[i]), kinds);
      });
    }
    case ParticleColor::temperature:
      return addDiscs(list, view, [&](std::size_t i) {
        return warmth(range.share(static_cast<double>(frame.temperature[i])));
      });
    case ParticleColor::content:
      return addDiscs(list, view, [&](std::size_t i) { return mapped(frame.content[i]); });
    case ParticleColor::id:
      return addDiscs(list, view, [&](std::size_t i) { return mapped(frame.id[i]); });
    case ParticleColor::height:
    case ParticleColor::strips: {
      const auto classes = static_cast<std::size_t>(view.style.classes);
      return addDiscs(list, view, [&](std::size_t i) {
        const std::optional<std::uint16_t> of = history.startClass(frame.id[i]);
        return of ? classColor(view.palette, *of, classes) : lateColor;
      });
    }
  }
}

void drawTrails(DrawList& list, const BedView& view, const History& history) {
  const float width = std::max(1.5f, view.camera.length(0.45 * view.scene.particles.diameter));
  const float dot = view.camera.length(0.7 * view.scene.particles.diameter);
  const bool repeats = view.scene.bed.sides == BedSides::periodic;
  const auto half = static_cast<float>(0.5 * view.scene.bed.width);
  const std::size_t first = list.lines.size();
  for (std::size_t n = 0; n < history.trails(); ++n) {
    const std::span<const History::Point> trail = history.trail(n);
    Rgba color = trailColors[n % trailColors.size()];
    for (std::size_t i = 1; i < trail.size(); ++i) {
      // It went out at one side and came in at the other.
      if (repeats && std::abs(trail[i].position.x - trail[i - 1].position.x) > half) continue;
      const double age = trail.back().time - trail[i].time;
      const float share = 1.0f - 0.8f * static_cast<float>(age / view.style.trailTime);
      list.lines.push_back({view.camera.toPixel(trail[i - 1].position),
                            view.camera.toPixel(trail[i].position), width * share, 0.0f, color});
    }
    if (trail.empty()) continue;
    const Vec2f at = view.camera.toPixel(trail.back().position);
    list.lines.push_back({at, at, dot, 0.0f, color});
  }
  addRims(list, first, 0.08f * view.em, view.palette.ground);
}

}  // namespace bedmix
