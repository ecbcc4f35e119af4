// SPDX-License-Identifier: MIT
#include "replay/analysis/line_flux.h"

#include "replay/analysis/by_id.h"

#include <utility>

namespace bedmix {

namespace {

/// Twice the area between the line and a point; above 0 on its left.
double leftOf(const FluxLine& line, Vec2 at) {
  const Vec2 along = line.to - line.from, away = at - line.from;
  return along.x * away.y - along.y * away.x;
}

/// Whether the way from a on one side to b on the other passes between the line's ends. What passes through
/// an end, or through the line's last point, belongs to a line that begins there.
bool passesBetween(const FluxLine& line, Vec2 a, Vec2 b) {
  const double before = leftOf(line, a), after = leftOf(line, b);
  const Vec2 along = line.to - line.from, at = a + (before / (before - after)) * (b - a) - line.from;
  const double place = dot(along, at);
  return place >= 0.0 && place < dot(along, along);
}

}  // namespace

LineFlux::LineFlux(const AnalysisInput& input, FluxLine line, std::string name)
    : line_(line),
      period_(input.scene),
      name_(std::move(name)),
      massOverArea_(particleMass(input.scene) / (norm(line.to - line.from) * input.scene.bed.thickness)),
      table_{{"time", "flux", "to_left", "to_right"}, std::vector<Table::Column>(4)} {}

void LineFlux::accept(const Frame& frame) {
  if (!previous_.id.empty()) {
    double toLeft = 0.0, toRight = 0.0;
    forParticlesInBoth(previous_.id, frame.id, [&](std::size_t i, std::size_t j) {
      const Vec2 a = toDouble(previous_.position[i]), b = toDouble(frame.position[j]);
      const auto pass = [&](Vec2 from, Vec2 to) {
        const bool wasLeft = leftOf(line_, from) >= 0.0, isLeft = leftOf(line_, to) >= 0.0;
        if (wasLeft == isLeft || !passesBetween(line_, from, to)) return;
        (isLeft ? toLeft : toRight) += 1.0;
      };
      const Vec2 by = period_.nearest(b - a);
      if (by == b - a) return pass(a, b);
      pass(a, a + by);  // out of the bed at one side
      pass(b - by, b);  // and in at the other
    });
    const double each = massOverArea_ / (frame.time - previous_.time);
    table_.append({frame.time, each * (toLeft - toRight), each * toLeft, each * toRight});
  }
  previous_.time = frame.time;
  previous_.position = frame.position;
  previous_.id = frame.id;
}

std::vector<FoundNumber> LineFlux::findings() const {
  std::vector<FoundNumber> found;
  for (std::size_t c = 1; c < table_.names.size(); ++c)
    found.push_back({name_ + '_' + table_.names[c], meanOf(table_.columns[c]), "kg/(m2 s)"});
  return found;
}

}  // namespace bedmix
