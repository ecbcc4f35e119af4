// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "engine/dem/particles.h"

#include <cstdint>
#include <string>

namespace bedmix::bench {

/// What all measured beds are made of: the paper's spheres without gas, friction 0.3, the same dashpot of
/// 0.015 kg/s (restitution 0.9) normal and tangential, in a bed that grows in width only, 0.096 m a thousand.
Scene bedScene(std::int64_t particles);

/// The same with gas, 2 u_mf over the whole floor, in the paper's 27 rows of cells and so many columns a
/// thousand particles; the paper has 8.
Scene gasScene(std::int64_t particles, std::int64_t columns = 8);

/// A thousand settled spheres side by side with themselves; `particles` is a multiple of 1,000. About 1.9
/// contacts a particle.
Particles packedBed(std::int64_t particles);

/// A square lattice of spacing 1.15 d whose spheres have 0.5 m/s in random directions, 500 steps later. About
/// 0.2 contacts a particle.
Particles agitatedBed(std::int64_t particles);

/// A bed from a file with one row `x y vx vy` (m, m/s) a particle, `tiles` times side by side. Fails where
/// the file cannot be read or holds anything else.
Result<Particles> readBed(const std::string& path, std::int64_t tiles = 1);

}  // namespace bedmix::bench
