// SPDX-License-Identifier: MIT
#include "render/painter.h"

#include "engine/core/mixing.h"
#include "render/chart.h"
#include "render/draw_bed.h"
#include "render/draw_sampling.h"
#include "render/hud.h"
#include "render/hud_rows.h"
#include "render/layers.h"
#include "render/layout.h"
#include "render/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace bedmix {

namespace {

constexpr std::size_t longestName = 16;  // characters, of a bed in its HUD

std::string shortened(std::string name) {
  if (name.size() > longestName) name = name.substr(0, longestName - 3) + "...";
  return name;
}

/// The beds of a picture, and all that follows from them and the options.
struct Composition {
  std::vector<Scene> scenes;
  std::vector<std::string> names;
  std::vector<SamplingGrid> grids;
  std::vector<IndexCurve> curves;
  std::vector<History> histories;
  Size size;
  Style style;
  PictureLayout layout;
  double until = 0.0;  // s, the longest of the runs
};

Result<Composition> compose(std::vector<PaintedBed> beds, const PaintOptions& options) {
  Composition made;
  for (PaintedBed& bed : beds) {
    made.scenes.push_back(std::move(bed.scene));
    made.names.push_back(shortened(std::move(bed.name)));
  }
  made.style = options.style;
  made.size = options.size == Size{} ? defaultSize(made.scenes, made.style) : options.size;
  std::vector<Diagnostic> problems = sizeProblems(made.size);
  for (const Scene& scene : made.scenes)
    for (Diagnostic& problem : missingFor(scene, made.style)) problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  made.layout = layoutPicture(made.scenes, options.part.value_or(wholeOf(made.size)), made.style);
  if (made.style.layers.has(Layer::counts))
    for (std::size_t i = 0; i < made.scenes.size(); ++i)
      for (Diagnostic& problem : countsProblems(made.scenes[i], made.layout.beds[i].camera, made.layout.em))
        problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  for (const Scene& scene : made.scenes) {
    made.grids.push_back(samplingGrid(scene));
    made.histories.emplace_back(scene, made.style);
    made.until = std::max(made.until, scene.time.duration);
  }
  made.curves.resize(made.scenes.size());
  return made;
}

}  // namespace

struct Painter::State : Composition {
  Surface surface;
  Hud hud;
  DrawList bed, overlay, chart;

  State(Composition composition, Surface drawing)
      : Composition(std::move(composition)), surface(std::move(drawing)), hud(layout.em) {
    take();
  }
  /// The size and the HUD's glyphs, where they are new.
  void take() {
    surface.setGlyphs(hud.glyphs());
    overlay.clip = wholeOf(size);
  }
  void drawOverlay(std::span<const Frame* const> frames);
};

Painter::Painter(std::unique_ptr<State> state) : state_(std::move(state)) {}
Painter::~Painter() = default;
Painter::Painter(Painter&&) noexcept = default;
Painter& Painter::operator=(Painter&&) noexcept = default;

Result<Painter> Painter::create(std::vector<PaintedBed> beds, const PaintOptions& options) {
  Result<Composition> composition = compose(std::move(beds), options);
  if (!composition) return composition.problems;
  Result<Surface> surface = Surface::create(options.threads);
  if (!surface) return surface.problems;
  return Painter(std::make_unique<State>(std::move(*composition), std::move(*surface)));
}

Result<Painter> Painter::create(const Scene& scene, const PaintOptions& options) {
  return create({{scene, ""}}, options);
}

Result<Done> Painter::change(std::vector<PaintedBed> beds, const PaintOptions& options) {
  State& s = *state_;
  Result<Composition> composition = compose(std::move(beds), options);
  if (!composition) return composition.problems;
  const bool isSameText = composition->layout.em == s.layout.em;
  if (composition->grids == s.grids) composition->curves = std::move(s.curves);
  static_cast<Composition&>(s) = std::move(*composition);
  if (!isSameText) s.hud = Hud(s.layout.em);
  s.take();
  return Done{};
}

void Painter::setPanelGlyphs(const GlyphSheet& glyphs) {
  state_->surface.setGlyphs(glyphs, Surface::Ui::panel);
}

Size Painter::size() const { return state_->size; }

std::size_t Painter::beds() const { return state_->scenes.size(); }

const PictureLayout& Painter::layout() const { return state_->layout; }

void Painter::observe(std::size_t bed, const Frame& frame) {
  State& s = *state_;
  s.histories[bed].observe(frame);
  if (s.style.layers.has(Layer::curve)) s.curves[bed].observe(mixingSample(frame, s.grids[bed]));
}

void Painter::State::drawOverlay(std::span<const Frame* const> frames) {
  chart.clear();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (style.layers.has(Layer::hud))
      drawHud(overlay, scenes[i], *frames[i], style, layout.beds[i], scenes.size() > 1 ? names[i] : "");
    until = std::max(until, frames[i]->time);
  }
  if (style.layers.has(Layer::curve))
    drawChart(chart, overlay, layout.chart, indexChart(names, curves), until, layout.em,
              paletteOn(style.ground));
}

Result<Done> Painter::paint(std::span<const Frame* const> frames, Image& into, const PaintOverlay& over) {
  State& s = *state_;
  for (std::size_t i = 0; i < s.scenes.size(); ++i)
    if (std::vector<Diagnostic> missing = missingFor(s.scenes[i], *frames[i], s.style); !missing.empty())
      return missing;
  into.resize(s.size);
  s.surface.begin(into, s.style.ground);
  s.overlay.clear();
  for (std::size_t i = 0; i < s.scenes.size(); ++i) {
    s.bed.clear();
    s.bed.clip = s.layout.beds[i].view;
    s.histories[i].observe(*frames[i]);
    drawBed(s.bed, s.scenes[i], *frames[i], s.layout.beds[i].camera, s.style, s.layout.em, s.histories[i]);
    s.surface.draw(s.bed);
    s.overlay.texts.insert(s.overlay.texts.end(), s.bed.texts.begin(), s.bed.texts.end());
  }
  s.drawOverlay(frames);
  s.surface.draw(s.overlay);
  s.surface.draw(s.chart);
  s.surface.draw(s.hud.mesh(s.size, s.overlay.texts));
  if (over.marks) s.surface.draw(*over.marks);
  if (over.panel) s.surface.draw(*over.panel, Surface::Ui::panel);
  s.surface.end();
  return Done{};
}

Result<Done> Painter::paint(const Frame& frame, Image& into) {
  const Frame* const one = &frame;
  return paint(std::span(&one, 1), into);
}

Size defaultSize(std::span<const Scene> scenes, const Style& style) {
  constexpr int height = 960, widest = 1280, chart = 560;
  int width = style.layers.has(Layer::curve) ? chart : 0;
  for (const Scene& scene : scenes) {
    // What is left beside HUD and walls.
    const double bed = 0.88 * height * scene.bed.width / viewHeight(scene);
    width += std::clamp(static_cast<int>(bed) + 340, 480, widest);
  }
  return {width - width % 2, height};
}

Result<Size> parseSize(std::string_view text) {
  Size size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec == std::errc{} && height.ptr == end) {
      std::vector<Diagnostic> problems = sizeProblems(size);
      if (!problems.empty()) return problems;
      return size;
    }
  }
  return Diagnostic{
      {}, fmt::format("'{}' is no picture size; write width x height in pixels, e.g. 1280x720", text)};
}

}  // namespace bedmix
