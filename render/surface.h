// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/draw_list.h"
#include "render/gl_context.h"
#include "render/image.h"
#include "render/ui_mesh.h"

#include <memory>
#include <string>

namespace bedmix {

/// Turns draw lists into pixels. Buffers and shaders live as long as the surface; a picture is drawn straight
/// into the caller's image. Used by one thread at a time.
class Surface {
 public:
  /// Who has glyphs of its own.
  enum class Ui { hud, panel };

  /// `threads`: see createGlContext.
  static Result<Surface> create(int threads, GlSource source = glSource());
  ~Surface();
  Surface(Surface&&) noexcept;
  Surface& operator=(Surface&&) noexcept;

  void setGlyphs(const GlyphSheet& glyphs, Ui ui = Ui::hud);

  /// A picture: begin, any number of draws one over the other, end. `image` has its size and must stay where
  /// it is until end(). The texts of a draw list are not drawn here but by the HUD. begin throws
  /// std::bad_alloc where OpenGL has no memory for the size.
  void begin(Image& image, Rgba ground);
  void draw(const DrawList& list);
  void draw(const UiMesh& mesh, Ui ui = Ui::hud);
  void end();

  /// Where OpenGL comes from, name and version of the rasterizer.
  std::string description() const;

 private:
  struct State;
  explicit Surface(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// What pictures are drawn with ("OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3"), or why nothing can
/// be drawn with this source.
Result<std::string> probeSurface(GlSource source = glSource());

/// Whether the rasterizer can draw this size; if not, why and what it can.
std::vector<Diagnostic> sizeProblems(Size size);

}  // namespace bedmix
