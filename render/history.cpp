// SPDX-License-Identifier: MIT
#include "render/history.h"

#include <algorithm>

namespace bedmix {

History::History(const Style& style)
    : trailTime_(style.trailTime),
      keepsStart_(style.layers.has(Layer::particles) && hasClasses(style.color)) {
  if (!style.layers.has(Layer::trails)) return;
  ids_ = style.trails;
  trails_.resize(ids_.size());
}

void History::observe(const Frame& frame) {
  if (keepsStart_ && start_.empty()) start_ = frame.position;
  // The newest point is dropped for the next one unless it is this much later than the one before it.
  const double spacing = trailTime_ / static_cast<double>(mostPoints - 2);
  for (std::size_t n = 0; n < ids_.size(); ++n) {
    const auto found = std::lower_bound(frame.id.begin(), frame.id.end(), ids_[n]);
    if (found == frame.id.end() || *found != ids_[n]) continue;
    std::vector<Point>& trail = trails_[n];
    while (!trail.empty() && trail.back().time >= frame.time) trail.pop_back();
    const std::size_t size = trail.size();
    if (size >= 2 && trail[size - 1].time - trail[size - 2].time < spacing * (1.0 - 1e-9)) trail.pop_back();
    trail.push_back({frame.time, frame.position[static_cast<std::size_t>(found - frame.id.begin())]});
    const double oldest = frame.time - trailTime_ * (1.0 + 1e-9);
    const auto kept =
        std::find_if(trail.begin(), trail.end(), [&](const Point& point) { return point.time >= oldest; });
    trail.erase(trail.begin(), kept);
  }
}

}  // namespace bedmix
