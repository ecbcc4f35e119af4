// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bedmix {

/// Solids flux through the scene's window, kg/(m2 s), positive leftward: the sum of m (-v_x) over the
/// particles whose centre lies within one diameter of the window's line and between its heights, over that
/// strip's volume. The scene must have a flux table.
double solidsFlux(const Frame& frame, const Scene& scene);

/// Mean gas pressure of the lowest open cells (each column's, weighted by width) minus the outlet's, Pa. The
/// frame must have gas.
double pressureDrop(const Frame& frame, const GasGrid& grid);

/// Height of the bed, m: the 95th percentile of the centres' heights above the floor below each, plus a
/// radius; 0 without particles.
double bedHeight(const Frame& frame, const Scene& scene);

/// Of particles by their mass, and of what leaves at the top, by its flow: mean temperatures, K. Where
/// nothing leaves, that of the topmost cells; none without particles. The frame must have temperatures.
std::optional<double> meanTemperature(const Frame& frame, const Scene& scene);
/// By mass as well, kg/kg. The frame must have a content.
std::optional<double> meanContent(const Frame& frame, const Scene& scene);
double outletTemperature(const Frame& frame, const GasGrid& grid);
/// Heat that the particles hold above what they would at heat.temperature, J.
double particleHeat(const Frame& frame, const Scene& scene);

/// Tags 1 = tracer by rule, for positions at the start, when nobody has been fed. `kind` is that of Frame,
/// and may be empty.
std::vector<std::uint8_t> tagTracer(TracerRule rule, const std::vector<Vec2f>& position,
                                    const std::vector<std::uint8_t>& kind, double width);
/// The same of one that comes in later.
std::uint8_t tagOfFed(TracerRule rule, std::uint8_t kind);

}  // namespace bedmix
