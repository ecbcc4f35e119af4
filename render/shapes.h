// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_list.h"

// What layers put together from the draw list's shapes.

namespace bedmix {

/// Whether nothing within `radius` of `at`, px, shows.
bool isOutside(const Box& clip, Vec2f at, float radius);

/// Between two opposite corners, px.
void addRectangle(DrawList& list, Vec2f a, Vec2f b, Rgba color);

/// An arrow from `tail` on by `shift`, px; none where it would be shorter than a pixel.
void addArrow(DrawList& list, Vec2f tail, Vec2f shift, float width, Rgba color);

/// Puts a rim of half a line's width, at most `widest` px, around all lines from number `first` on, so that
/// they show on any ground.
void addRims(DrawList& list, std::size_t first, float widest, Rgba color);

}  // namespace bedmix
