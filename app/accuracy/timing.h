// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/sample.h"
#include "engine/core/scene.h"
#include "engine/dem/particles.h"

namespace bedmix {

/// Wall time, s, of `stretch` simulated s from `start`, and what it was spent on. Nothing else should run.
void measureTime(const Scene& scene, const Particles& start, double stretch, Sample& into);

}  // namespace bedmix
