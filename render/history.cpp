// SPDX-License-Identifier: MIT
#include "render/history.h"

#include <algorithm>
#include <numeric>

namespace bedmix {

namespace {

/// `n` classes of as many particles each, the lowest first.
std::vector<std::uint16_t> byHeight(const std::vector<Vec2f>& position, std::size_t n) {
  std::vector<std::size_t> order(position.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return position[a].y < position[b].y; });
  std::vector<std::uint16_t> classes(position.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    classes[order[k]] = static_cast<std::uint16_t>(k * n / order.size());
  return classes;
}

/// `n` strips of equal width, the leftmost first.
std::vector<std::uint16_t> byStrip(const std::vector<Vec2f>& position, std::size_t n, double width) {
  std::vector<std::uint16_t> classes;
  for (const Vec2f& p : position) {
    const double at = static_cast<double>(p.x) / width * static_cast<double>(n);
    classes.push_back(static_cast<std::uint16_t>(std::clamp(at, 0.0, static_cast<double>(n - 1))));
  }
  return classes;
}

}  // namespace

History::History(const Scene& scene, const Style& style) : style_(style), width_(scene.bed.width) {
  if (style.layers.has(Layer::trails)) trails_.resize(style.trails.size());
}

void History::observe(const Frame& frame) {
  if (style_.layers.has(Layer::particles) && hasClasses(style_.color) && startClass_.empty()) {
    const auto classes = static_cast<std::size_t>(style_.classes);
    startClass_ = style_.color == ParticleColor::height ? byHeight(frame.position, classes)
                                                        : byStrip(frame.position, classes, width_);
    startId_ = frame.id;
  }
  // The newest point gives way to the next unless it is this much later than the one before it.
  const double spacing = style_.trailTime / static_cast<double>(mostPoints - 2);
  for (std::size_t n = 0; n < trails_.size(); ++n) {
    const auto found = std::lower_bound(frame.id.begin(), frame.id.end(), style_.trails[n]);
    if (found == frame.id.end() || *found != style_.trails[n]) continue;
    std::vector<Point>& trail = trails_[n];
    while (!trail.empty() && trail.back().time >= frame.time) trail.pop_back();
    const std::size_t size = trail.size();
    if (size >= 2 && trail[size - 1].time - trail[size - 2].time < spacing * (1.0 - 1e-9)) trail.pop_back();
    trail.push_back({frame.time, frame.position[static_cast<std::size_t>(found - frame.id.begin())]});
    const double oldest = frame.time - style_.trailTime * (1.0 + 1e-9);
    const auto kept =
        std::find_if(trail.begin(), trail.end(), [&](const Point& point) { return point.time >= oldest; });
    trail.erase(trail.begin(), kept);
  }
}

std::optional<std::uint16_t> History::startClass(std::int32_t id) const {
  // Most often no particle has left, and ids count up by one.
  const auto guess = startId_.empty() ? 0 : static_cast<std::size_t>(std::int64_t{id} - startId_.front());
  if (guess < startId_.size() && startId_[guess] == id) return startClass_[guess];
  const auto found = std::lower_bound(startId_.begin(), startId_.end(), id);
  if (found == startId_.end() || *found != id) return std::nullopt;
  return startClass_[static_cast<std::size_t>(found - startId_.begin())];
}

}  // namespace bedmix
