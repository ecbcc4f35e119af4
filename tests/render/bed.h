// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <initializer_list>

namespace bedmix::test {

/// The bed of Tian et al. (2007): 96 x 420 mm, gas at 2 u_mf through the whole floor.
Scene flatBed();
/// The same on a distributor inclined by 18 deg, gas through its outer quarters at 5 and 3 u_mf.
Scene inclinedBed();
/// The flat bed without gas.
Scene gaslessBed();

/// A bed in motion, made by hand: the scene's particles on a wide hexagonal lattice, every third one tracer,
/// turning about the middle; voidage with a bubble, pressure falling to zero at the surface.
Frame movingFrame(const Scene& scene, double time = 0.5);

/// Particles of species 1 (black) and 0 (green) at these places, at rest, without gas.
Frame particlesAt(std::initializer_list<Vec2f> black, std::initializer_list<Vec2f> green, double time = 0.0);

}  // namespace bedmix::test
