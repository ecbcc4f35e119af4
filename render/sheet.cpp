// SPDX-License-Identifier: MIT
#include "render/sheet.h"

#include "engine/core/mixing.h"
#include "render/draw_bed.h"
#include "render/draw_sampling.h"
#include "render/draw_walls.h"
#include "render/hud.h"
#include "render/hud_rows.h"
#include "render/layers.h"
#include "render/layout.h"
#include "render/legend.h"
#include "render/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

namespace {

// px at 300 dpi, and em of them.
constexpr float pageWidth = 2244.0f;   // 190 mm
constexpr float widestPanel = 420.0f;  // 36 mm: few panels do not fill the page
constexpr float em = 33.0f;            // 8 pt
constexpr float margin = 0.7f;         // em, around the sheet
constexpr float gap = 1.2f;            // em, between panels at least
constexpr float titleBand = 1.9f;      // em, above the panels of a run that has a title
constexpr float runGap = 0.9f;         // em, between runs
constexpr float labelBand = 1.5f;      // em, above a panel
constexpr float scaleBarBand = 1.6f;   // em, below the last row
constexpr float keyWidth = 13.0f;      // em
constexpr std::size_t longestRow = 9;
constexpr float inner = pageWidth - 2.0f * margin * em;

/// The height the panels of a run show, m: a diameter more than the highest particle; what is thrown far
/// above the bed is cut. Sampling cells are shown whole, with room for arrows that begin above them.
double shownHeight(const SheetRun& run, Layers layers) {
  float highest = 0.0f;
  for (const FramePtr& frame : run.frames)
    for (const Vec2f& p : frame->position) highest = std::max(highest, p.y);
  double height = static_cast<double>(highest) + 1.5 * run.scene->particles.diameter;
  if (layers.has(Layer::sampling) || layers.has(Layer::counts) || layers.has(Layer::flow)) {
    const SamplingGrid grid = samplingGrid(*run.scene);
    const double cell = grid.height / grid.rows;
    height = cell * std::ceil(height / cell) +
             (layers.has(Layer::flow) ? 0.5 * cell : 0.5 * run.scene->particles.diameter);
  }
  return std::min(height, 1.5 * run.scene->bed.height);
}

/// Where the panels of a run go, all with the same camera but for its place.
struct Grid {
  std::size_t columns = 0, rows = 0;
  float top = 0.0f;  // px, of the run's part of the sheet
  float columnStep = 0.0f, rowStep = 0.0f;
  Vec2f first;  // px, lower left corner of the first bed
  Vec2f bed;    // px, width and height of the part that is shown

  explicit Grid(std::size_t panels)
      : columns((panels + rowsOf(panels) - 1) / rowsOf(panels)), rows(rowsOf(panels)) {}
  static std::size_t rowsOf(std::size_t panels) { return (panels + longestRow - 1) / longestRow; }

  /// px between the beds of a row.
  float gaps() const { return static_cast<float>(columns - 1) * gap * em; }

  /// Lower left corner of a bed.
  Vec2f corner(std::size_t panel) const {
    const std::size_t row = panel / columns, column = panel % columns;
    return first + Vec2f{static_cast<float>(column) * columnStep, static_cast<float>(row) * rowStep};
  }

  /// What a panel may draw on: the bed, its walls and what is below it.
  Box box(std::size_t panel) const {
    const Vec2f at = corner(panel);
    const float side = 0.5f * gap * em, above = at.y - bed.y;
    return {at.x - side, above, at.x + bed.x + side, above + rowStep - labelBand * em};
  }
};

struct Page {
  std::vector<Grid> runs;
  float scale = 0.0f;  // px per m
  int legendRows = 0;
  Vec2f legend;  // px, its upper left corner
  Size size;
};

/// Rows of the legend; none where a caption says as well what is tracer.
int rowsOfLegend(const Style& style) {
  const Layers said = style.layers.has(Layer::particles) ? Layers{Layer::particles} : Layers{};
  const int rows = legendRows(style);
  return style.color != ParticleColor::tracer || rows > legendRows(said) ? rows : 0;
}

Page arrange(std::span<const SheetRun> runs, const Style& style, const Hud& hud) {
  Page page;
  page.legendRows = rowsOfLegend(style);
  page.scale = std::numeric_limits<float>::max();
  for (const SheetRun& run : runs) {
    const Grid& grid = page.runs.emplace_back(run.frames.size());
    const float panel = std::min((inner - grid.gaps()) / static_cast<float>(grid.columns), widestPanel);
    page.scale = std::min(page.scale, panel / static_cast<float>(run.scene->bed.width));
  }
  float top = margin * em, panels = 0.0f, width = 0.0f;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Scene& scene = *runs[i].scene;
    Grid& grid = page.runs[i];
    const float below = style.layers.has(Layer::walls) ? inletArrowHeight(scene, em) : 0.0f;
    grid.bed = {page.scale * static_cast<float>(scene.bed.width),
                page.scale * static_cast<float>(shownHeight(runs[i], style.layers))};
    grid.columnStep = grid.bed.x + gap * em;
    grid.rowStep = labelBand * em + grid.bed.y + below + 0.5f * em;
    if (i > 0) top += runGap * em;
    grid.top = top;
    if (!runs[i].title.empty()) top += titleBand * em;
    grid.first = {margin * em, top + labelBand * em + grid.bed.y};
    top += static_cast<float>(grid.rows) * grid.rowStep;
    panels = std::max(panels, static_cast<float>(grid.columns) * grid.bed.x + grid.gaps());
    width = std::max({width, panels, std::min(hud.width(runs[i].title), inner)});
  }
  float bottom = top + scaleBarBand * em;
  if (page.legendRows > 0) {
    const Grid& first = page.runs.front();
    const float height = hudLine * static_cast<float>(page.legendRows) * em;
    if (panels + (gap + keyWidth) * em <= inner) {  // beside the panels
      page.legend = {(margin + gap) * em + panels, first.first.y - first.bed.y};
      width = std::max(width, panels + (gap + keyWidth) * em);
      bottom = std::max(bottom, page.legend.y + height);
    } else {  // beside the scale bar
      page.legend = {(margin + keyWidth) * em, top};
      bottom = std::max(bottom, top + height + 0.5f * margin * em);
    }
  }
  page.size = {static_cast<int>(std::ceil(2.0f * margin * em + width)), static_cast<int>(std::ceil(bottom))};
  return page;
}

/// As much of a title as fits a page.
std::string fitting(std::string title, const Hud& hud) {
  if (hud.width(title) <= inner) return title;
  while (!title.empty() && hud.width(title + "...") > inner) {
    do title.pop_back();
    while (!title.empty() && (static_cast<unsigned char>(title.back()) & 0xC0) == 0x80);  // within UTF-8
  }
  return title + "...";
}

std::vector<Diagnostic> problemsOf(std::span<const SheetRun> runs, const Style& style) {
  std::vector<Diagnostic> problems;
  for (const SheetRun& run : runs) {
    if (run.frames.empty()) problems.push_back({{}, "a sheet needs at least one time"});
    for (Diagnostic& d : missingFor(*run.scene, style)) problems.push_back(std::move(d));
    for (const FramePtr& frame : run.frames)
      if (problems.empty()) problems = missingFor(*run.scene, *frame, style);
    if (!problems.empty()) break;
  }
  return problems;
}

}  // namespace

Result<std::vector<std::size_t>> framesAt(std::span<const double> times, std::span<const double> wanted) {
  constexpr double rounding = 5e-7;  // s; times in decimals may lie a bit beside those of the frames
  const std::size_t count = times.size();
  const double interval = count > 1 ? times[count - 1] - times[count - 2] : 0.0;
  std::vector<std::size_t> indices;
  std::vector<Diagnostic> problems;
  for (const double time : wanted) {
    const auto after = std::upper_bound(times.begin(), times.end(), time + rounding);
    // Written so that a time that is no number is none of the run's.
    if (after != times.begin() && time <= times.back() + 0.5 * interval + rounding)
      indices.push_back(static_cast<std::size_t>(after - times.begin()) - 1);
    else
      problems.push_back({{},
                          fmt::format("there is no frame at t = {:g} s; the run goes from {:g} to {:g} s",
                                      time, times.front(), times.back())});
  }
  if (!problems.empty()) return problems;
  return indices;
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

Result<Image> drawSheet(std::span<const SheetRun> runs, const Style& style) {
  if (runs.empty()) return Diagnostic{{}, "a sheet needs at least one run"};
  Hud hud(em);
  std::vector<Diagnostic> problems = problemsOf(runs, style);
  if (!problems.empty()) return problems;
  const Page page = arrange(runs, style, hud);
  problems = sizeProblems(page.size);
  if (style.layers.has(Layer::counts))
    for (const SheetRun& run : runs)
      for (Diagnostic& d : countsProblems(*run.scene, {{}, page.scale}, em)) problems.push_back(std::move(d));
  if (!problems.empty()) return problems;
  Result<Surface> surface = Surface::create(0);
  if (!surface) return surface.problems;
  surface->setGlyphs(hud.glyphs());

  std::vector<double> times;
  for (const SheetRun& run : runs)
    for (const FramePtr& frame : run.frames) times.push_back(frame->time);
  const int decimals = timeDecimals(times);

  Image sheet;
  sheet.resize(page.size);
  surface->begin(sheet, style.ground);
  DrawList all;  // what does not belong to one panel
  all.clip = {0.0f, 0.0f, static_cast<float>(page.size.width), static_cast<float>(page.size.height)};
  const Rgba color = paletteOn(style.ground).ink;
  DrawList panel;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Grid& grid = page.runs[r];
    for (std::size_t i = 0; i < runs[r].frames.size(); ++i) {
      panel.clear();
      panel.clip = grid.box(i);
      drawBed(panel, *runs[r].scene, *runs[r].frames[i], {grid.corner(i), page.scale}, style, em,
              runs[r].histories.empty() ? History() : runs[r].histories[i]);
      surface->draw(panel);
      all.texts.insert(all.texts.end(), panel.texts.begin(), panel.texts.end());
      all.texts.push_back({{0.5f * (panel.clip.left + panel.clip.right), panel.clip.top - 0.25f * em},
                           {0.5f, 1.0f},
                           color,
                           timeLabel(runs[r].frames[i]->time, decimals)});
    }
    if (!runs[r].title.empty())
      all.texts.push_back({{grid.first.x, grid.top}, {0.0f, 0.0f}, color, fitting(runs[r].title, hud)});
  }
  const Camera camera{page.runs.front().first, page.scale};
  drawScaleBar(all, *runs.front().scene, camera, {camera.origin.x, all.clip.bottom - 0.6f * em}, em, color);
  if (page.legendRows > 0) drawLegend(all, page.legend, *runs.front().scene, style, camera, em);
  surface->draw(all);
  surface->draw(hud.mesh(page.size, all.texts));
  surface->end();
  return sheet;
}

}  // namespace bedmix
