// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/draw_list.h"
#include "render/image.h"
#include "render/layout.h"
#include "render/style.h"
#include "render/ui_mesh.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

struct PaintOptions {
  Size size;  // 0 x 0: defaultSize(scene)
  Style style;
  int threads = 0;               // of the rasterizer, 0 = all cores; the first painter of the program decides
  std::optional<Box> part = {};  // of the picture that shows the beds; all of it where not given
};

/// One of the beds of a picture.
struct PaintedBed {
  Scene scene;
  std::string name;  // tells it from the others; not shown of a single one
};

/// What else a picture shows, over the beds.
struct PaintOverlay {
  const DrawList* marks = nullptr;  // without texts
  const UiMesh* panel = nullptr;    // of the glyphs of setPanelGlyphs()
};

/// Draws frames off-screen: of one bed, or of several side by side to one scale; whole beds in view, HUD
/// beside or above each, whichever leaves it larger. The same frames twice give the same bytes. Not
/// thread-safe, but a painter may move between threads.
class Painter {
 public:
  /// Fails as `input` for a size outside the limits or a layer a scene cannot show, as `unavailable` where
  /// OpenGL is.
  static Result<Painter> create(std::vector<PaintedBed> beds, const PaintOptions& options = {});
  static Result<Painter> create(const Scene& scene, const PaintOptions& options = {});
  ~Painter();
  Painter(Painter&&) noexcept;
  Painter& operator=(Painter&&) noexcept;

  /// From now on draws these, likewise, with the OpenGL it has. Where this fails, it stays as it was. Of the
  /// time before, no more than the curves of the indices is kept, and only of sampling grids that stay.
  Result<Done> change(std::vector<PaintedBed> beds, const PaintOptions& options);
  void setPanelGlyphs(const GlyphSheet& glyphs);

  Size size() const;
  std::size_t beds() const;
  const PictureLayout& layout() const;
  /// Takes note of a frame that may not be painted itself, for what pictures show of the time before theirs.
  /// In order of time for each bed.
  void observe(std::size_t bed, const Frame& frame);
  /// One frame a bed. `into` is resized and overwritten; keep it for the next frame and nothing is allocated.
  /// Fails where a frame lacks the gas a layer needs.
  Result<Done> paint(std::span<const Frame* const> frames, Image& into, const PaintOverlay& overlay = {});
  Result<Done> paint(const Frame& frame, Image& into);

 private:
  struct State;
  explicit Painter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A picture that fits the beds, their HUDs and the chart of a style; both numbers even.
Size defaultSize(std::span<const Scene> scenes, const Style& style);
inline Size defaultSize(const Scene& scene, const Style& style = {}) {
  return defaultSize(std::span(&scene, 1), style);
}

/// Reads "1280x720"; each between 16 and 16384, the limits of the rasterizer.
Result<Size> parseSize(std::string_view text);

}  // namespace bedmix
