// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>

namespace bedmix {

/// An OpenGL 3.3 core context without a window or a display: all that the rest needs to know of the system's
/// OpenGL. Pictures are drawn into framebuffers and read back. Used by one thread at a time.
class GlContext {
 public:
  using Function = void (*)();

  virtual ~GlContext() = default;
  virtual std::string name() const = 0;
  /// From now on this thread's OpenGL is this one.
  virtual bool makeCurrent() = 0;
  /// This thread has none any more; another one may take it.
  virtual void release() = 0;
  virtual Function function(const char* name) const = 0;
};

/// Where contexts come from: Mesa's own off-screen library, or EGL without a surface. `automatic` is OSMesa,
/// and EGL where that is not there: Mesa 25.1 is the first without it. Pictures are the same.
enum class GlSource { automatic, osmesa, egl };
/// The names users know them by, in the order of GlSource.
inline constexpr std::array<std::string_view, 3> glSourceNames{"auto", "osmesa", "egl"};

/// In use: automatic unless told otherwise, for all threads.
GlSource glSource();
void useGlSource(GlSource source);

/// `threads` of Mesa's llvmpipe (0: as many as cores) counts for the first
/// context of the program; LP_NUM_THREADS in the environment wins over it. Fails as `unavailable`, saying of
/// each source tried what is missing.
Result<std::unique_ptr<GlContext>> createGlContext(int threads, GlSource source);

// The two sources. Their libraries are opened when first asked for, so that the program starts without them.
Result<std::unique_ptr<GlContext>> createOsmesaContext();
Result<std::unique_ptr<GlContext>> createEglContext();

/// What the rasterizer can draw, px a side.
inline constexpr int smallestSide = 16;
inline constexpr int largestSide = 16384;

}  // namespace bedmix
