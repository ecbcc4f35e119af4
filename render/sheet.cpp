// SPDX-License-Identifier: MIT
#include "render/sheet.h"

#include "render/draw_bed.h"
#include "render/draw_walls.h"
#include "render/hud.h"
#include "render/hud_rows.h"
#include "render/layers.h"
#include "render/layout.h"
#include "render/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// px at 300 dpi, and em of them.
constexpr float pageWidth = 2244.0f;   // 190 mm
constexpr float widestPanel = 420.0f;  // 36 mm: few panels do not fill the page
constexpr float em = 33.0f;            // 8 pt
constexpr float margin = 0.7f;         // em, around the sheet
constexpr float gap = 1.2f;            // em, between panels at least
constexpr float labelBand = 1.5f;      // em, above a panel
constexpr float scaleBarBand = 1.6f;   // em, below the last row
constexpr std::size_t longestRow = 9;

/// The height all panels show, m: a diameter more than the highest particle; what is thrown far above the bed
/// is cut.
double shownHeight(const Scene& scene, std::span<const FramePtr> frames) {
  float highest = 0.0f;
  for (const FramePtr& frame : frames)
    for (const Vec2f& p : frame->position) highest = std::max(highest, p.y);
  return std::min(static_cast<double>(highest) + 1.5 * scene.particles.diameter, 1.5 * scene.bed.height);
}

/// Where the panels go, all with the same camera but for its place.
struct Grid {
  std::size_t columns = 0, rows = 0;
  float scale = 0.0f;  // px per m
  float columnStep = 0.0f, rowStep = 0.0f;
  Vec2f first;  // px, lower left corner of the first bed
  Vec2f bed;    // px, width and height of the part that is shown
  Size size;

  /// Lower left corner of a bed.
  Vec2f corner(std::size_t panel) const {
    const std::size_t row = panel / columns, column = panel % columns;
    return first + Vec2f{static_cast<float>(column) * columnStep, static_cast<float>(row) * rowStep};
  }
};

/// What a panel may draw on: the bed, its walls and what is below it.
Box panelBox(const Grid& grid, std::size_t panel) {
  const Vec2f corner = grid.corner(panel);
  const float side = 0.5f * gap * em, top = corner.y - grid.bed.y;
  return {corner.x - side, top, corner.x + grid.bed.x + side, top + grid.rowStep - labelBand * em};
}

Grid arrange(const Scene& scene, std::size_t panels, double height, Layers layers) {
  Grid grid;
  grid.rows = (panels + longestRow - 1) / longestRow;
  grid.columns = (panels + grid.rows - 1) / grid.rows;
  const float columns = static_cast<float>(grid.columns), rows = static_cast<float>(grid.rows);
  const float inner = pageWidth - 2.0f * margin * em;
  const float panel = std::min((inner - (columns - 1.0f) * gap * em) / columns, widestPanel);
  const float below = layers.has(Layer::walls) ? inletArrowHeight(scene, em) : 0.0f;
  grid.scale = panel / static_cast<float>(scene.bed.width);
  grid.bed = {panel, grid.scale * static_cast<float>(height)};
  grid.columnStep = panel + gap * em;
  grid.rowStep = labelBand * em + grid.bed.y + below + 0.5f * em;
  grid.first = {margin * em, margin * em + labelBand * em + grid.bed.y};
  grid.size = {
      static_cast<int>(std::ceil(2.0f * margin * em + columns * panel + (columns - 1.0f) * gap * em)),
      static_cast<int>(std::ceil(margin * em + rows * grid.rowStep + scaleBarBand * em))};
  return grid;
}

}  // namespace

FramesAt::FramesAt(std::vector<double> times) : times_(std::move(times)), frames_(times_.size()) {}

void FramesAt::accept(const Frame& frame) {
  constexpr double rounding = 5e-7;
  FramePtr kept;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (frame.time > times_[i] + rounding) continue;
    if (!kept) kept = std::make_shared<const Frame>(frame);
    frames_[i] = kept;
  }
  if (last_) interval_ = frame.time - *last_;
  last_ = frame.time;
}

Result<std::vector<FramePtr>> FramesAt::frames() const {
  std::vector<Diagnostic> problems;
  for (std::size_t i = 0; i < times_.size(); ++i)
    if (!frames_[i] || times_[i] > *last_ + 0.5 * interval_)
      problems.push_back({{},
                          fmt::format("there is no frame at t = {:g} s; the run ends at {:g} s", times_[i],
                                      last_.value_or(0.0))});
  if (!problems.empty()) return problems;
  return frames_;
}

std::vector<double> defaultSheetTimes(double duration) {
  std::vector<double> times;
  if (duration < 1.0) {
    for (int i = 0; i < 5; ++i) times.push_back(duration * i / 4.0);
    return times;
  }
  for (const double time : {0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0})
    if (time <= duration) times.push_back(time);
  return times;
}

Result<Image> drawSheet(const Scene& scene, std::span<const FramePtr> frames, Layers layers) {
  if (frames.empty()) return Diagnostic{{}, "a sheet needs at least one time"};
  std::vector<Diagnostic> problems = missingFor(scene, layers);
  for (const FramePtr& frame : frames)
    if (problems.empty()) problems = missingFor(scene, *frame, layers);
  const Grid grid = arrange(scene, frames.size(), shownHeight(scene, frames), layers);
  if (problems.empty()) problems = sizeProblems(grid.size);
  if (!problems.empty()) return problems;
  Result<Surface> surface = Surface::create(0);
  if (!surface) return surface.problems;
  Hud hud(em);
  surface->setGlyphs(hud.glyphs());

  std::vector<double> times;
  for (const FramePtr& frame : frames) times.push_back(frame->time);
  const int decimals = timeDecimals(times);

  Image sheet;
  sheet.resize(grid.size);
  surface->begin(sheet, white);
  std::vector<Text> texts;
  DrawList panel;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    panel.clear();
    panel.clip = panelBox(grid, i);
    drawBed(panel, scene, *frames[i], {grid.corner(i), grid.scale}, layers, em);
    surface->draw(panel);
    texts.push_back({{0.5f * (panel.clip.left + panel.clip.right), panel.clip.top - 0.25f * em},
                     {0.5f, 1.0f},
                     ink,
                     timeLabel(times[i], decimals)});
  }
  DrawList bar;
  bar.clip = {0.0f, 0.0f, static_cast<float>(grid.size.width), static_cast<float>(grid.size.height)};
  drawScaleBar(bar, scene, {grid.first, grid.scale}, {grid.first.x, bar.clip.bottom - 0.6f * em}, em);
  texts.insert(texts.end(), bar.texts.begin(), bar.texts.end());
  surface->draw(bar);
  surface->draw(hud.mesh(grid.size, texts));
  surface->end();
  return sheet;
}

}  // namespace bedmix
