// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/sampling_grid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bedmix {

/// Whole particles per cell.
struct CellCounts {
  std::vector<std::int32_t> all;
  std::vector<std::int32_t> tracer;
};
CellCounts countCells(const Frame& frame, const SamplingGrid& grid);

/// Mean velocity of the particles in each cell, m/s, zero where there are fewer than
/// `fewest`.
std::vector<Vec2> meanVelocities(const Frame& frame, const SamplingGrid& grid, std::int32_t fewest);

/// One row of mixing.csv. What is not defined at an instant (no used cell; no variance; one species only) is
/// empty.
struct MixingSample {
  double time = 0.0;                       // s
  std::optional<double> lacey;             // Eq. (14)
  std::optional<double> ashton;            // Eq. (15)
  std::optional<double> stddev;            // S, Eq. (13)
  std::optional<double> tracerMean;        // mean tracer fraction of the used cells
  int cells = 0;                           // used cells
  std::optional<double> particlesPerCell;  // mean over the used cells
  double countedFraction = 0.0;            // particles in used cells over all particles
};

/// A bed counts as mixed from the first time on at which Ashton's index is this high, as in Tian et al.
/// (2007).
inline constexpr double mixedIndex = 0.9;

/// Lacey's and Ashton's indices after Tian et al. (2007), Eqs (13) to (15). Integer counts only, so the order
/// of the particles cannot matter; positions are the frame's floats, so that live and replayed samples agree
/// to the bit.
MixingSample mixingSample(const Frame& frame, const SamplingGrid& grid);

/// The same from counts: the one place where the indices are computed.
MixingSample mixingSample(const CellCounts& counts, int minParticles, double time, std::size_t particles);

}  // namespace bedmix
