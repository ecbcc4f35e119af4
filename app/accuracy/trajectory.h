// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "engine/dem/particles.h"

#include <vector>

namespace bedmix {

/// How fast runs of a scene part that begin almost alike.
struct Divergence {
  double growth = 0.0;  // 1/s, of the logarithm of their distance; 0 where they do not part
  double predictable =
      0.0;  // s, until a millionth of a diameter has become a tenth; infinite where growth is 0
};

/// From twin runs of which one has its particles moved by a millionth of a diameter at random; followed for
/// `longest` s, fitted where the distance is above that and below a hundredth. Fails where a twin does.
Result<Divergence> measureDivergence(const Scene& scene, const Particles& start, double longest);

/// The scene's frame at the horizon, s, or why there is none.
Result<FramePtr> frameAt(const Scene& scene, const Particles& start, double horizon);

/// Of the particles of two frames, in their order, diameters.
std::vector<double> distances(const Frame& a, const Frame& b, double diameter);

}  // namespace bedmix
