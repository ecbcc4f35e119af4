// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/color.h"

#include <array>

// Every colour of the pictures, told apart by the colour-blind and in grey print: Okabe and Ito's palette
// (https://jfly.uni-koeln.de/color/), the paper's black and green, and two perceptually uniform maps.

namespace bedmix {

inline constexpr Rgba ink = black;               // text, scale bar
inline constexpr Rgba tracerColor{0, 0, 0};      // species 1
inline constexpr Rgba restColor{0, 158, 115};    // species 0
inline constexpr Rgba lateColor{150, 150, 150};  // without a class: not there at the start
inline constexpr Rgba velocityColor{230, 159, 0};
inline constexpr Rgba gasColor{0, 114, 178};
inline constexpr Rgba samplingColor{86, 180, 233};
inline constexpr Rgba flowColor{213, 94, 0};
inline constexpr Rgba bubbleColor{204, 121, 167};
inline constexpr Rgba forceColor{240, 228, 66};
inline constexpr Rgba wallColor{70, 70, 70};
inline constexpr Rgba distributorColor{205, 205, 205};

/// Of curves: dark to light in grey too.
inline constexpr std::array seriesColors{ink,           restColor,     gasColor,
                                         velocityColor, samplingColor, Rgba{204, 121, 167}};
/// Of trails.
inline constexpr std::array trailColors{flowColor, samplingColor, velocityColor, bubbleColor, gasColor};

/// What colours have to be on a ground to be seen.
struct Palette {
  Rgba ground = white;
  Rgba ink = bedmix::ink;     // text, scale bar
  Rgba grid{208, 208, 208};   // of axes
  Rgba tracer = tracerColor;  // species 1
  Rgba sampling = samplingColor;
  Rgba gas = gasColor;    // arrows and streamlines of the gas
  Rgba wall = wallColor;  // also the edge of light lines
  Rgba distributor = distributorColor;
  double lowest = 0.0, highest = 0.92;  // the part of cividis that discs are seen in
};
/// Dark ink on a light ground, light ink on a dark one, whichever has more contrast (WCAG 2.1).
Palette paletteOn(Rgba ground);

/// Colour of t in [0, 1] (clamped) on cividis, dark blue to yellow: Nunez, Anderton & Renslow (2018), PLoS
/// ONE 13:e0199239, by the polynomials of d3-scale-chromatic. In 256 steps.
Rgba cividis(double t);

/// Colour of t in [-1, 1] (clamped), blue over grey to red, for what has a sign: Moreland (2009), Diverging
/// color maps for scientific visualization, with a middle of lightness 80 that shows on white. In 256 steps.
Rgba coolWarm(double t);
/// The same for t in [0, 1], cold to warm.
inline Rgba warmth(double t) { return coolWarm(2.0 * t - 1.0); }

}  // namespace bedmix
