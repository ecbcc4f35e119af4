// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/image.h"
#include "render/style.h"

#include <memory>
#include <string>
#include <string_view>

namespace bedmix {

struct PaintOptions {
  Size size;  // 0 x 0: defaultSize(scene)
  Style style;
  int threads = 0;  // of the rasterizer, 0 = all cores; the first painter of the program decides
};

/// Draws frames of one scene off-screen: whole bed in view, HUD beside or above it, whichever leaves the bed
/// larger. The same frame twice gives the same bytes. Not thread-safe, but a painter may move between
/// threads.
class Painter {
 public:
  /// Fails as `input` for a size outside the limits or a layer the scene cannot show, as `unavailable` where
  /// OpenGL is.
  static Result<Painter> create(const Scene& scene, const PaintOptions& options = {});
  ~Painter();
  Painter(Painter&&) noexcept;
  Painter& operator=(Painter&&) noexcept;

  Size size() const;
  /// `into` is resized and overwritten; keep it for the next frame and nothing is allocated. Fails where the
  /// frame lacks the gas a layer needs.
  Result<Done> paint(const Frame& frame, Image& into);

 private:
  struct State;
  explicit Painter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A portrait picture that fits the bed and the HUD; both numbers even.
Size defaultSize(const Scene& scene);

/// Reads "1280x720"; each between 16 and 16384, the limits of the rasterizer.
Result<Size> parseSize(std::string_view text);

}  // namespace bedmix
