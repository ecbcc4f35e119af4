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

/// What all cell-based indices are made of: the cells that hold at least `minParticles`, which are the used
/// ones, after Tian et al. (2007), Eqs (13) to (15), every cell counting once, and with each cell counting as
/// often as it has particles.
struct CellStatistics {
  int cells = 0;                   // used cells, K
  std::int64_t particles = 0;      // in used cells, N
  std::int64_t tracer = 0;         // of those
  double mean = 0.0;               // mean tracer fraction of the used cells
  double perCell = 0.0;            // particles in a used cell on average
  double segregated = 0.0;         // sigma_0^2 = mean (1 - mean)
  double random = 0.0;             // sigma_r^2 = sigma_0^2/perCell
  std::optional<double> variance;  // S^2, Eq. (13); from two used cells on
  double weightedVariance = 0.0;   // sum n (C - p)^2/N, with p = tracer/N
  double entropy = 0.0;            // sum n h(C)/N, with h(c) = -c ln c - (1-c) ln(1-c)

  /// Whether there are both species and more than one particle a cell, without which no index is defined.
  bool defined() const { return variance && segregated > random; }
};
CellStatistics cellStatistics(const CellCounts& counts, int minParticles);

/// Tian et al. (2007), Eqs (14) and (15). Empty where not defined; Ashton's also without any variance.
std::optional<double> laceyIndex(const CellStatistics& cells);
std::optional<double> ashtonIndex(const CellStatistics& cells);

/// Entropy of a mixture of fractions c and 1 - c, in nats.
double mixtureEntropy(double c);

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

/// The same from statistics, of a frame of so many particles.
MixingSample mixingSample(const CellStatistics& cells, double time, std::size_t particles);

}  // namespace bedmix
