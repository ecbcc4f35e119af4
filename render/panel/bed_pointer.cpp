// SPDX-License-Identifier: MIT
#include "render/panel/bed_pointer.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr int mostColumns = 40, mostRows = 100;

bool contains(const Box& box, Vec2f at) {
  return at.x >= box.left && at.x < box.right && at.y >= box.top && at.y < box.bottom;
}

Vec2 metresAt(const Camera& camera, Vec2f at) {
  return {static_cast<double>((at.x - camera.origin.x) / camera.scale), camera.heightAt(at.y)};
}

/// The particle whose disc is under the pointer or, within reach, next to it.
std::optional<PickedParticle> particleAt(const PanelModel& model, const BedPointer::Pointer& pointer) {
  for (std::size_t b = 0; b < model.beds.size(); ++b) {
    const PanelBed& bed = model.beds[b];
    if (!bed.frame || !contains(bed.layout.view, pointer.at)) continue;
    float nearest = std::max(bed.layout.camera.length(0.5 * bed.scene->particles.diameter), pointer.reach);
    std::optional<PickedParticle> found;
    for (std::size_t i = 0; i < bed.frame->size(); ++i) {
      const Vec2f at = bed.layout.camera.toPixel(bed.frame->position[i]);
      const float distance = std::hypot(at.x - pointer.at.x, at.y - pointer.at.y);
      if (distance > nearest) continue;
      nearest = distance;
      found = {b, bed.frame->id[i]};
    }
    return found;
  }
  return std::nullopt;
}

/// Which line between `n` cells of [0, length] is within `reach` of `at`; 0 for none.
int nearLine(double at, double length, int n, double reach) {
  const int line = static_cast<int>(std::lround(at / length * n));
  return line >= 1 && line < n && std::abs(line * length / n - at) <= reach ? line : 0;
}

}  // namespace

std::optional<BedPointer::GridLine> BedPointer::lineAt(const PanelModel& model,
                                                       const Pointer& pointer) const {
  if (!model.style.layers.has(Layer::sampling)) return std::nullopt;
  for (std::size_t b = 0; b < model.beds.size(); ++b) {
    const PanelBed& bed = model.beds[b];
    if (!contains(bed.layout.view, pointer.at)) continue;
    const Vec2 at = metresAt(bed.layout.camera, pointer.at);
    const double reach = static_cast<double>(pointer.reach / bed.layout.camera.scale);
    if (at.x < 0.0 || at.x > bed.scene->bed.width || at.y < 0.0 || at.y > bed.scene->bed.height) continue;
    if (const int n = nearLine(at.x, bed.scene->bed.width, model.grid.columns, reach))
      return GridLine{b, true, n};
    if (const int n = nearLine(at.y, bed.scene->bed.height, model.grid.rows, reach))
      return GridLine{b, false, n};
  }
  return std::nullopt;
}

/// The line stays under the pointer, as near as whole cells allow.
void BedPointer::drag(const PanelModel& model, const Pointer& pointer,
                      std::vector<PanelAction>& actions) const {
  const PanelBed& bed = model.beds[dragged_->bed];
  const Vec2 at = metresAt(bed.layout.camera, pointer.at);
  const auto cells = [&](double length, double place, int most) {
    const double wanted = dragged_->n * length / std::max(place, 1e-9 * length);
    return static_cast<int>(std::clamp(std::round(wanted), dragged_->n + 1.0, static_cast<double>(most)));
  };
  int columns = model.grid.columns, rows = model.grid.rows;
  if (dragged_->isUpright)
    columns = cells(bed.scene->bed.width, at.x, mostColumns);
  else
    rows = cells(bed.scene->bed.height, at.y, mostRows);
  if (columns != model.grid.columns || rows != model.grid.rows)
    actions.push_back({PanelAction::Resample{columns, rows, model.grid.minParticles}});
}

void BedPointer::update(const PanelModel& model, const Pointer& pointer, std::vector<PanelAction>& actions) {
  if (!pointer.isDown) dragged_.reset();
  const std::optional<GridLine> under = dragged_ ? dragged_ : lineAt(model, pointer);
  cursor_ = !under ? "" : under->isUpright ? "ew-resize" : "ns-resize";
  if (pointer.isPressed) {
    dragged_ = under;
    if (!under) actions.push_back({PanelAction::Pick{particleAt(model, pointer)}});
  }
  if (dragged_ && dragged_->bed < model.beds.size()) drag(model, pointer, actions);
}

}  // namespace bedmix
