// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix {

/// Appends the particles as discs in the style's colour. Over a coloured field they get a rim inside their
/// edge: black would be lost on its dark end.
void drawParticles(DrawList& list, const BedView& view, const History& history);

/// Appends the trails, fading with age, each with its particle as a dot of the same colour.
void drawTrails(DrawList& list, const BedView& view, const History& history);

/// Colour of one of the classes of the start: the paper's black and green for two, else even steps.
Rgba classColor(const Palette& palette, std::size_t index, std::size_t classes);

/// The part of cividis that discs are drawn in: t in [0, 1].
Rgba discColor(const Palette& palette, double t);

}  // namespace bedmix
