// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

namespace {

constexpr float chartHeight = 7.0f;  // em

struct Range {
  float low, high;
};

/// Of the values, somewhat widened; of the model where that says so.
Range rangeOf(const PanelChart& chart) {
  if (chart.low != chart.high) return {chart.low, chart.high};
  Range range{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
  for (const PanelCurve& curve : chart.curves)
    for (const Vec2f& point : curve.points)
      if (std::isfinite(point.y)) range = {std::min(range.low, point.y), std::max(range.high, point.y)};
  if (range.low > range.high) return {0.0f, 1.0f};
  const float spare = std::max(0.05f * (range.high - range.low), 1e-6f);
  return {range.low - spare, range.high + spare};
}

struct Axes {
  ImVec2 low, high;  // px, corners of the chart
  double begin, end;
  Range values;

  float x(double time) const {
    return low.x + static_cast<float>((time - begin) / std::max(end - begin, 1e-9)) * (high.x - low.x);
  }
  float y(float value) const {
    return high.y - (value - values.low) / (values.high - values.low) * (high.y - low.y);
  }
};

/// Points that fall on one pixel column more than twice are left out.
void drawCurve(const PanelCurve& curve, const Axes& axes) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 last{std::numeric_limits<float>::quiet_NaN(), 0.0f};
  for (const Vec2f& point : curve.points) {
    const ImVec2 at{axes.x(static_cast<double>(point.x)), axes.y(point.y)};
    if (!std::isfinite(at.y)) {
      last.x = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    if (at.x - last.x < 0.5f) continue;
    if (std::isfinite(last.x)) list.AddLine(last, at, packed(curve.color), 1.5f);
    last = at;
  }
}

void chartOf(const PanelModel& model, const PanelChart& chart, PanelActions& actions) {
  text(chart.label.empty() ? std::string(chart.title) : fmt::format("{}: {}", chart.label, chart.title));
  for (const PanelCurve& curve : chart.curves) {
    if (chart.curves.size() < 2) break;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, packed(curve.color));
    text(curve.name);
    ImGui::PopStyleColor();
  }
  const float em = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, em), chartHeight * em};
  ImGui::InvisibleButton(chart.title.data(), size);
  const Axes axes{at, {at.x + size.x, at.y + size.y}, model.begin, model.end, rangeOf(chart)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(axes.low, axes.high, IM_COL32(18, 22, 28, 255));
  list.PushClipRect(axes.low, axes.high, true);
  for (const PanelCurve& curve : chart.curves) drawCurve(curve, axes);
  if (!model.isLive)
    list.AddLine({axes.x(model.time), axes.low.y}, {axes.x(model.time), axes.high.y},
                 IM_COL32(255, 255, 255, 120));
  list.PopClipRect();
  const ImU32 ink = IM_COL32(170, 175, 185, 255);
  list.AddText({at.x + 0.3f * em, at.y}, ink, fmt::format("{:.3g}", axes.values.high).c_str());
  list.AddText({at.x + 0.3f * em, axes.high.y - em}, ink, fmt::format("{:.3g}", axes.values.low).c_str());
  const std::string end = fmt::format("{:.4g} s", model.end);
  list.AddText({axes.high.x - ImGui::CalcTextSize(end.c_str()).x - 0.3f * em, axes.high.y - em}, ink,
               end.c_str());
  if (!model.isLive && ImGui::IsItemActive() && size.x > 0.0f) {
    const double share = static_cast<double>((ImGui::GetIO().MousePos.x - at.x) / size.x);
    actions.push_back(
        {PanelAction::Seek{model.begin + std::clamp(share, 0.0, 1.0) * (model.end - model.begin)}});
  }
}

}  // namespace

void chartSection(const PanelModel& model, PanelActions& actions) {
  if (model.charts.empty() || !section("Curves", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (std::size_t i = 0; i < model.charts.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    chartOf(model, model.charts[i], actions);
    ImGui::PopID();
  }
}

}  // namespace bedmix
