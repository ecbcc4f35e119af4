// SPDX-License-Identifier: MIT
#include "app/view/view_series.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/mixing.h"

#include <limits>
#include <string_view>

namespace bedmix {

namespace {

constexpr float undefined = std::numeric_limits<float>::quiet_NaN();
// On the panel's dark ground.
constexpr Rgba laceyColor{86, 180, 233}, ashtonColor{240, 228, 66}, otherColor{0, 190, 140};

float orUndefined(std::optional<double> value) { return value ? static_cast<float>(*value) : undefined; }

}  // namespace

ViewSeries::ViewSeries(const Scene& scene) : scene_(scene), grid_(samplingGrid(scene)) {
  if (scene.gas) gas_ = makeGasGrid(scene);
}

void ViewSeries::observe(const Frame& frame) {
  const auto time = static_cast<float>(frame.time);
  if (!points_.empty() && !(time > points_.back().time)) return;
  if (seen_++ % stride_ != 0) return;
  const MixingSample sample = mixingSample(frame, grid_);
  points_.push_back({time, orUndefined(sample.lacey), orUndefined(sample.ashton),
                     scene_.flux ? static_cast<float>(solidsFlux(frame, scene_)) : undefined,
                     gas_ && frame.hasGas() ? static_cast<float>(pressureDrop(frame, *gas_)) : undefined});
  if (points_.size() < mostPoints) return;
  for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
  points_.resize((points_.size() + 1) / 2);
  stride_ *= 2;
}

void ViewSeries::resample(const SamplingGrid& grid) {
  if (grid == grid_) return;
  grid_ = grid;
  for (Point& point : points_) point.lacey = point.ashton = undefined;
}

std::vector<PanelChart> ViewSeries::charts() const {
  const auto curve = [&](std::string_view name, Rgba color, float Point::*value) {
    PanelCurve made{name, color, {}};
    made.points.reserve(points_.size());
    for (const Point& point : points_) made.points.push_back({point.time, point.*value});
    return made;
  };
  std::vector<PanelChart> charts;
  charts.push_back({"Mixing index",
                    {curve("Lacey", laceyColor, &Point::lacey), curve("Ashton", ashtonColor, &Point::ashton)},
                    0.0f,
                    1.1f});
  if (scene_.flux)
    charts.push_back({"Solids flux, kg/(m\u00b2 s)", {curve("flux", otherColor, &Point::flux)}, 0.0f, 0.0f});
  if (gas_)
    charts.push_back({"Pressure drop, Pa", {curve("pressure", otherColor, &Point::pressure)}, 0.0f, 0.0f});
  return charts;
}

}  // namespace bedmix
