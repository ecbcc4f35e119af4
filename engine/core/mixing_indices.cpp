// SPDX-License-Identifier: MIT
#include "engine/core/mixing_indices.h"

#include "engine/core/neighbour_index.h"

#include <array>
#include <cmath>

namespace bedmix {

namespace {

double kramers(const CellStatistics& s) {
  return (std::sqrt(s.segregated) - std::sqrt(*s.variance)) / (std::sqrt(s.segregated) - std::sqrt(s.random));
}
double poole(const CellStatistics& s) { return std::sqrt(*s.variance / s.random); }
double rose(const CellStatistics& s) { return 1.0 - std::sqrt(*s.variance / s.segregated); }
double danckwerts(const CellStatistics& s) { return *s.variance / s.segregated; }
double entropy(const CellStatistics& s) {
  return s.entropy / mixtureEntropy(static_cast<double>(s.tracer) / static_cast<double>(s.particles));
}

/// A function of the cells where they define it.
template <double (*formula)(const CellStatistics&)>
std::optional<double> ofCells(const MixingState& state) {
  if (!state.cells.defined()) return std::nullopt;
  return formula(state.cells);
}

constexpr std::array indices{
    MixingIndex{"lacey", "(sigma_0^2 - S^2)/(sigma_0^2 - sigma_r^2)",
                "Lacey (1954), J. Appl. Chem. 4:257; as in Tian et al. (2007), Eq. (14)", "cells",
                [](const MixingState& state) { return laceyIndex(state.cells); }},
    MixingIndex{
        "ashton", "(ln sigma_0 - ln S)/(ln sigma_0 - ln sigma_r)",
        "Ashton & Valentin (1966), Trans. Inst. Chem. Eng. 44:T166; as in Tian et al. (2007), Eq. (15)",
        "cells", [](const MixingState& state) { return ashtonIndex(state.cells); }},
    MixingIndex{
        "lacey_weighted", "(1 - S_w^2/(p (1-p)))/(1 - (K-1)/(N-1)), S_w^2 = sum n (C - p)^2/N",
        "Lacey (1954); weights as in Chandratilleke et al. (2012), AIChE J. 58:1099; limits: this program",
        "cells", [](const MixingState& state) { return weightedLaceyIndex(state.cells); }},
    MixingIndex{"kramers", "(sigma_0 - S)/(sigma_0 - sigma_r)", "Kramers, cited by Lacey (1954)", "cells",
                ofCells<kramers>},
    MixingIndex{"poole", "S/sigma_r", "Poole, Taylor & Wall (1964), Trans. Inst. Chem. Eng. 42:T305", "cells",
                ofCells<poole>},
    MixingIndex{"rose", "1 - S/sigma_0", "Rose (1959), Trans. Inst. Chem. Eng. 37:47", "cells",
                ofCells<rose>},
    MixingIndex{"danckwerts", "S^2/sigma_0^2", "Danckwerts (1952), Appl. Sci. Res. A 3:279", "cells",
                ofCells<danckwerts>},
    MixingIndex{"entropy", "sum n h(C)/(N h(p)), h(c) = -c ln c - (1-c) ln(1-c)",
                "Shannon (1948), Bell Syst. Tech. J. 27:379; conditional on place as in Camesasca, Kaufman & "
                "Manas-Zloczower (2006), Macromol. Theory Simul. 15:595",
                "cells", ofCells<entropy>},
    MixingIndex{
        "nearest_neighbour", "unlike among the 6 nearest/(2 p (1-p) N/(N-1)), all particles",
        "Godlieb, Deen & Kuipers (2007), 6th Int. Conf. Multiphase Flow, Leipzig", "positions",
        [](const MixingState& state) { return neighbourIndex(state.frame, planeNeighbours, state.period); }},
    MixingIndex{"gmmi_x", "mean x of the tracer/mean x of all",
                "Asmar, Langston & Matchett (2002), Granular Matter 4:129", "positions",
                [](const MixingState& state) { return meanPositionIndex(state.frame).x; }},
    MixingIndex{"gmmi_y", "mean y of the tracer/mean y of all",
                "Asmar, Langston & Matchett (2002), Granular Matter 4:129", "positions",
                [](const MixingState& state) { return meanPositionIndex(state.frame).y; }},
    MixingIndex{"principal_component",
                "largest eigenvalue of C^T C, C_ij = correlation of position i now with position j at the "
                "start, over its value at the start",
                "Doucet, Bertrand & Chaouki (2008), Chem. Eng. Res. Des. 86:1313", "positions and ids",
                [](const MixingState& state) -> std::optional<double> {
                  const auto found = state.start.with(state.frame);
                  if (!found) return std::nullopt;
                  return found->index;
                }},
};

}  // namespace

std::span<const MixingIndex> mixingIndices() { return indices; }

std::optional<double> weightedLaceyIndex(const CellStatistics& s) {
  if (s.cells < 2 || s.particles <= s.cells || s.tracer == 0 || s.tracer == s.particles) return std::nullopt;
  const double n = static_cast<double>(s.particles), p = static_cast<double>(s.tracer) / n;
  return (1.0 - s.weightedVariance / (p * (1.0 - p))) / (1.0 - (s.cells - 1) / (n - 1.0));
}

MeanPositionIndex meanPositionIndex(const Frame& frame) {
  Vec2 all, tracer;
  std::size_t tagged = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2 at{static_cast<double>(frame.position[i].x), static_cast<double>(frame.position[i].y)};
    all += at;
    if (frame.species[i] != 1) continue;
    tracer += at;
    ++tagged;
  }
  if (tagged == 0 || tagged == frame.size()) return {};
  const double scale = static_cast<double>(frame.size()) / static_cast<double>(tagged);
  const auto ratio = [scale](double part, double whole) -> std::optional<double> {
    if (!(whole > 0.0)) return std::nullopt;
    return scale * part / whole;
  };
  return {ratio(tracer.x, all.x), ratio(tracer.y, all.y)};
}

}  // namespace bedmix
