// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <memory>

namespace bedmix {

/// An OpenGL 3.3 core context that draws into memory, without a display. All that the rest needs to know of
/// the system's OpenGL; another one (EGL without a surface, say) is another class like OSMesa's.
class GlContext {
 public:
  using Function = void (*)();

  virtual ~GlContext() = default;
  /// From now on this thread's OpenGL draws here, into `image`: its pixels are valid after glFinish.
  virtual bool makeCurrent(Image& image) = 0;
  /// Lets go of the image.
  virtual void release() = 0;
  virtual Function function(const char* name) const = 0;
};

/// The off-screen rasterizer of Mesa. `threads` of llvmpipe (0: as many as cores) counts for the first
/// context of the program; LP_NUM_THREADS in the environment wins over it.
Result<std::unique_ptr<GlContext>> createGlContext(int threads);

/// What the rasterizer can draw, px a side.
inline constexpr int smallestSide = 16;
inline constexpr int largestSide = 16384;

}  // namespace bedmix
