// SPDX-License-Identifier: MIT
#include "app/view/particle_marks.h"

#include "render/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

std::optional<std::size_t> rowOf(const Frame& frame, std::int32_t id) {
  const auto found = std::lower_bound(frame.id.begin(), frame.id.end(), id);
  if (found == frame.id.end() || *found != id) return std::nullopt;
  return static_cast<std::size_t>(found - frame.id.begin());
}

void addRing(DrawList& list, Vec2f middle, float radius, float width, Rgba color) {
  constexpr int sides = 24;
  const auto corner = [&](int k) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / sides;
    return Vec2f{middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
  };
  for (int k = 0; k < sides; ++k) list.lines.push_back({corner(k), corner(k + 1), width, 0.0f, color});
}

}  // namespace

void drawParticleMarks(DrawList& list, const std::vector<ViewBed>& beds, const PictureLayout& layout,
                       const std::optional<PickedParticle>& picked) {
  list.clear();
  if (!picked) return;
  const ViewBed& bed = beds[picked->bed];
  const Layout& place = layout.beds[picked->bed];
  list.clip = place.view;
  const float width = std::max(1.0f, 0.1f * place.em);
  for (std::size_t i = 1; i < bed.path.size(); ++i)
    list.lines.push_back(
        {place.camera.toPixel(bed.path[i - 1]), place.camera.toPixel(bed.path[i]), width, 0.0f, flowColor});
  if (!bed.frame) return;
  if (const auto row = rowOf(*bed.frame, picked->id))
    addRing(list, place.camera.toPixel(bed.frame->position[*row]),
            place.camera.length(0.5 * bed.scene->particles.diameter) + 2.0f * width, 2.0f * width, flowColor);
}

std::vector<PanelFact> particleFacts(const ViewBed& bed, std::int32_t id) {
  std::vector<PanelFact> facts{{"number", fmt::format("{}", id)}};
  if (!bed.frame) return facts;
  const Frame& frame = *bed.frame;
  const auto row = rowOf(frame, id);
  if (!row) return {{"number", fmt::format("{}, not there now", id)}};
  const Vec2f at = frame.position[*row], v = frame.velocity[*row];
  facts.push_back({"tracer", frame.species[*row] != 0 ? "yes" : "no"});
  facts.push_back({"position", fmt::format("{:.1f}, {:.1f} mm", 1e3 * at.x, 1e3 * at.y)});
  facts.push_back({"velocity", fmt::format("{:.3f}, {:.3f} m/s", v.x, v.y)});
  facts.push_back({"speed", fmt::format("{:.3f} m/s", std::hypot(v.x, v.y))});
  if (!frame.angularVelocity.empty())
    facts.push_back({"spin", fmt::format("{:.3g} rad/s", frame.angularVelocity[*row])});
  if (!frame.temperature.empty())
    facts.push_back({"temperature", fmt::format("{:.1f} K", frame.temperature[*row])});
  if (!frame.content.empty()) facts.push_back({"content", fmt::format("{:.4f}", frame.content[*row])});
  return facts;
}

}  // namespace bedmix
