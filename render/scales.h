// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

// What colours, lengths and widths of the pictures stand for. All follow from the scene alone, so that
// frames compare.

namespace bedmix {

/// Superficial velocity of the gas over the bed's whole cross section, m/s. The scene must have gas.
double meanInflow(const Scene& scene);

/// Values at the ends of a colour bar.
struct ColorRange {
  double low = 0.0;
  double high = 1.0;
  double share(double value) const { return (value - low) / (high - low); }
};
/// Of a layer that colours gas cells: voidage (packed to empty), pressure (Pa, 0 to somewhat more than the
/// bed's weight per area), gas speed (m/s, 0 to somewhat more than through inlets and packed bed),
/// temperature (K, as of the particles).
ColorRange colorRange(const Scene& scene, Layer field);
/// Of the particles: speed (m/s, 0 to somewhat more than sqrt(g width)), spin (rad/s, even
/// about 0), voidage, temperature (K, between all that the scene names), content, id, or the share of the way
/// through the classes.
ColorRange colorRange(const Scene& scene, ParticleColor color);

/// How long the arrows of velocity, flow or gas are in the bed: metres per m/s.
double arrowScale(const Scene& scene, Layer arrows);

/// The force whose line is as wide as a particle, N: about three times what the bed's weight makes on a
/// contact at the floor.
double forceScale(const Scene& scene);

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0), and the least that is not
/// below.
double roundDown(double value);
double roundUp(double value);

}  // namespace bedmix
