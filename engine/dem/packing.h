// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/thread_team.h"
#include "engine/dem/particles.h"

namespace bedmix {

/// The scene's particles as its run begins, at rest.
///
/// `drop`: on randomly chosen sites of a lattice above the highest point of the floor, each shifted at random
/// within its site, so that none touch. `settled`: dropped so and, without gas but with the scene's contacts
/// and step, left to fall until the fastest is slower than 1 mm/s for 0.02 s on end, 3 s at most; with
/// velocity Verlet where that step is given, so that every integrator starts from the same bed. While they
/// fall a viscous force -10 1/s m v slows them, which ends the wait sooner and keeps overlaps small; it
/// vanishes at rest.
///
/// The same seed gives the same bits. Fails where a lid leaves too little room, and where settling breaks the
/// scene's overlap limit.
Result<Particles> packBed(const Scene& scene, ThreadTeam& team = oneThread());

}  // namespace bedmix
