// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/draw_bed.h"

#include <vector>

namespace bedmix {

/// Appends the edges of the cells in which tracer is counted, and hatches those with too few particles to be
/// used (Tian et al. 2007, Fig. 5), where a cell has room for it.
void drawSampling(DrawList& list, const BedView& view);

/// Appends, in each used cell, its number of particles above its tracer fraction.
void drawCounts(DrawList& list, const BedView& view);

/// Appends hatching of a part of the picture, px.
void addHatching(DrawList& list, const Box& box, float em, Rgba color);

/// Whether the cells have room for the layer counts; if not, how large the picture must be.
std::vector<Diagnostic> countsProblems(const Scene& scene, const Camera& camera, float em);

}  // namespace bedmix
