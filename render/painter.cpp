// SPDX-License-Identifier: MIT
#include "render/painter.h"

#include "render/hud.h"
#include "render/hud_rows.h"
#include "render/layout.h"
#include "render/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace bedmix {

struct Painter::State {
  Scene scene;
  Size size;
  Style style;
  Layout layout;
  Surface surface;
  Hud hud;
  DrawList bed, overlay;
};

Painter::Painter(std::unique_ptr<State> state) : state_(std::move(state)) {}
Painter::~Painter() = default;
Painter::Painter(Painter&&) noexcept = default;
Painter& Painter::operator=(Painter&&) noexcept = default;

Result<Painter> Painter::create(const Scene& scene, const PaintOptions& options) {
  const Size size = options.size == Size{} ? defaultSize(scene) : options.size;
  std::vector<Diagnostic> problems = sizeProblems(size);
  for (Diagnostic& problem : missingFor(scene, options.style.layers)) problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  Result<Surface> surface = Surface::create(options.threads);
  if (!surface) return surface.problems;

  const Layout layout = layoutPicture(scene, size, options.style.layers);
  auto state = std::make_unique<State>(
      State{scene, size, options.style, layout, std::move(*surface), Hud(layout.em), {}, {}});
  state->surface.setGlyphs(state->hud.glyphs());
  state->bed.clip = layout.view;
  state->overlay.clip = {0.0f, 0.0f, static_cast<float>(size.width), static_cast<float>(size.height)};
  return Painter(std::move(state));
}

Size Painter::size() const { return state_->size; }

Result<Done> Painter::paint(const Frame& frame, Image& into) {
  State& s = *state_;
  if (std::vector<Diagnostic> missing = missingFor(s.scene, frame, s.style.layers); !missing.empty())
    return missing;
  into.resize(s.size);
  s.bed.clear();
  s.overlay.clear();
  drawBed(s.bed, s.scene, frame, s.layout.camera, s.style, s.layout.em);
  if (s.style.layers.has(Layer::hud)) drawHud(s.overlay, s.scene, frame, s.style.layers, s.layout);

  s.surface.begin(into, white);
  s.surface.draw(s.bed);
  s.surface.draw(s.overlay);
  s.surface.draw(s.hud.mesh(s.size, s.overlay.texts));
  s.surface.end();
  return Done{};
}

Size defaultSize(const Scene& scene) {
  constexpr int height = 960, widest = 1280;
  const double bed =
      0.88 * height * scene.bed.width / viewHeight(scene);  // what is left beside HUD and walls
  const int width = std::clamp(static_cast<int>(bed) + 340, 480, widest);
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
