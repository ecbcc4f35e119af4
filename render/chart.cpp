// SPDX-License-Identifier: MIT
#include "render/chart.h"

#include "render/scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// In em.
constexpr float tickBand = 3.2f;    // left of the axes, for their numbers
constexpr float timeBand = 2.9f;    // below them
constexpr float keyLine = 1.35f;    // a row of the key above them
constexpr float numberHalf = 1.6f;  // right of them, for half of the last number
constexpr float tickRow = 1.3f;     // of a number beside them
constexpr float tickLength = 0.3f;
constexpr float keyLength = 1.6f;  // of a curve's sample in the key

constexpr double lowest = 0.0, highest = 1.4;  // indices: noise goes beyond 1

/// Distance of round ticks, about `wanted` of them up to `until`.
double tickStep(double until, double wanted) {
  const double rough = until / wanted, down = roundDown(rough);
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (factor * down >= rough * (1.0 - 1e-9)) return factor * down;
  return 10.0 * down;
}

}  // namespace

Chart indexChart(std::span<const std::string> labels, std::span<const IndexCurve> runs) {
  if (runs.size() == 1)
    return {"mixing index",
            {{"Lacey", seriesColors[0], &runs[0], &IndexCurve::Point::lacey},
             {"Ashton", seriesColors[1], &runs[0], &IndexCurve::Point::ashton}}};
  Chart chart{"Ashton index", {}};
  for (std::size_t i = 0; i < runs.size(); ++i)
    chart.curves.push_back(
        {labels[i], seriesColors[i % seriesColors.size()], &runs[i], &IndexCurve::Point::ashton});
  return chart;
}

Box chartAxes(const Box& box, std::size_t curves, float em) {
  Box axes = box;
  axes.left += tickBand * em;
  axes.right -= numberHalf * em;
  axes.top += (keyLine * static_cast<float>(curves + 1) + 0.4f) * em;
  axes.bottom -= timeBand * em;
  return axes;
}

void drawChart(DrawList& list, DrawList& overlay, const Box& box, const Chart& chart, double until, float em,
               const Palette& palette) {
  const Box axes = chartAxes(box, chart.curves.size(), em);
  list.clip = axes;
  const float thin = std::max(1.0f, 0.06f * em), thick = std::max(1.5f, 0.12f * em);
  const auto x = [&](double t) { return axes.left + axes.width() * static_cast<float>(t / until); };
  const auto y = [&](double index) {
    return axes.bottom - axes.height() * static_cast<float>((index - lowest) / (highest - lowest));
  };

  const double indexStep = axes.height() > 7.0f * tickRow * em ? 0.2 : 0.7;
  for (int i = 0; lowest + i * indexStep <= highest + 1e-9; ++i) {
    const float at = y(lowest + i * indexStep);
    overlay.lines.push_back({{axes.left, at}, {axes.right, at}, thin, 0.0f, palette.grid});
    overlay.texts.push_back({{axes.left - 0.5f * em, at},
                             {1.0f, 0.5f},
                             palette.ink,
                             fmt::format("{:.1f}", lowest + i * indexStep)});
  }
  const double step = tickStep(until, std::clamp(static_cast<double>(axes.width() / (4.0f * em)), 1.0, 6.0));
  for (int i = 0; i * step <= until * (1.0 + 1e-9); ++i) {
    const float at = x(i * step);
    overlay.lines.push_back({{at, axes.top}, {at, axes.bottom}, thin, 0.0f, palette.grid});
    overlay.lines.push_back(
        {{at, axes.bottom}, {at, axes.bottom + tickLength * em}, thick, 0.0f, palette.ink});
    overlay.texts.push_back(
        {{at, axes.bottom + 0.4f * em}, {0.5f, 0.0f}, palette.ink, fmt::format("{:.6g}", i * step)});
  }
  overlay.lines.push_back({{axes.left, axes.bottom}, {axes.right, axes.bottom}, thick, 0.0f, palette.ink});
  overlay.lines.push_back({{axes.left, axes.top}, {axes.left, axes.bottom}, thick, 0.0f, palette.ink});
  overlay.texts.push_back(
      {{0.5f * (axes.left + axes.right), axes.bottom + 1.6f * em}, {0.5f, 0.0f}, palette.ink, "t, s"});

  float row = box.top + 0.55f * em;
  overlay.texts.push_back({{axes.left, row}, {0.0f, 0.5f}, palette.ink, chart.title});
  row += keyLine * em;
  for (const ChartCurve& c : chart.curves) {
    const Rgba color = c.color == ink ? palette.ink : c.color;
    overlay.lines.push_back({{axes.left, row}, {axes.left + keyLength * em, row}, thick, 0.0f, color});
    overlay.texts.push_back({{axes.left + (keyLength + 0.5f) * em, row}, {0.0f, 0.5f}, palette.ink, c.label});
    row += keyLine * em;

    const auto& points = c.curve->points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const float from = points[i - 1].*c.index, to = points[i].*c.index;
      if (!std::isfinite(from) || !std::isfinite(to)) continue;
      list.lines.push_back({{x(static_cast<double>(points[i - 1].time)), y(static_cast<double>(from))},
                            {x(static_cast<double>(points[i].time)), y(static_cast<double>(to))},
                            thick,
                            0.0f,
                            color});
    }
  }
}

}  // namespace bedmix
