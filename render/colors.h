// SPDX-License-Identifier: MIT
#pragma once

#include "render/image.h"

#include <array>

// Every colour of the pictures, told apart by the colour-blind and in grey print: Okabe and Ito's palette
// (https://jfly.uni-koeln.de/color/), the paper's black and green, and one perceptually uniform map.

namespace bedmix {

inline constexpr Rgba white{255, 255, 255};
inline constexpr Rgba ink{0, 0, 0};                // text, scale bar
inline constexpr Rgba tracerColor{0, 0, 0};        // species 1
inline constexpr Rgba restColor{0, 158, 115};      // species 0
inline constexpr Rgba velocityColor{230, 159, 0};  // arrows of the particles
inline constexpr Rgba gasColor{0, 114, 178};       // arrows of the gas
inline constexpr Rgba samplingColor{86, 180, 233};
inline constexpr Rgba wallColor{70, 70, 70};
inline constexpr Rgba distributorColor{205, 205, 205};

/// Of curves: dark to light in grey too.
inline constexpr std::array seriesColors{ink,           restColor,     gasColor,
                                         velocityColor, samplingColor, Rgba{204, 121, 167}};

/// Colour of t in [0, 1] (clamped) on cividis, dark blue to yellow: Nunez, Anderton & Renslow (2018), PLoS
/// ONE 13:e0199239, by the polynomials of d3-scale-chromatic.
Rgba cividis(double t);

}  // namespace bedmix
