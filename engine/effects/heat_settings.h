// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"

#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// What the gas adds to [heat]; the defaults are those of air at 20 deg C.
struct HeatGasSettings {
  double heatCapacity = 1006.0;                 // J/(kg K), at constant pressure
  double conductivity = 0.0257;                 // W/(m K)
  double temperature = 293.15;                  // K, at the start
  std::optional<double> inletTemperature = {};  // K; that of the start where absent
};

/// Temperatures of particles and gas; see HeatStage.
struct HeatSettings {
  static constexpr Key table{"heat", "", {}, "switches on temperatures of particles and gas"};

  double heatCapacity = 0.0;    // J/(kg K), of the solid
  double conductivity = 0.0;    // W/(m K), of the solid
  double temperature = 293.15;  // K, of the particles at the start
  std::optional<double> tracerTemperature =
      {};                                      // K, of the tracer at the start; that of the rest where absent
  std::optional<double> wallTemperature = {};  // K; adiabatic walls where absent
  std::optional<double> youngsModulus =
      {};                      // Pa, of the real solid; contacts as wide as overlaps where absent
  double poissonRatio = 0.25;  // of the real solid
  std::optional<HeatGasSettings> gas = {};

  double inletTemperature() const { return gas->inletTemperature.value_or(gas->temperature); }
};

template <class V>
void describe(HeatGasSettings& s, V& visit) {
  visit(Key{"heat_capacity", "J/(kg K)", positive, "of the gas, at constant pressure"}, s.heatCapacity);
  visit(Key{"conductivity", "W/(m K)", positive, "of the gas"}, s.conductivity);
  visit(Key{"temperature", "K", {0.0, 5000.0}, "of the gas at the start"}, s.temperature);
  visit(Key{"inlet_temperature", "K", {0.0, 5000.0}, "of what enters; that of the start where absent"},
        s.inletTemperature);
}

template <class V>
void describe(HeatSettings& s, V& visit) {
  visit(Key{"heat_capacity", "J/(kg K)", positive, "of the solid", true}, s.heatCapacity);
  visit(Key{"conductivity", "W/(m K)", notNegative, "of the solid; 0 for no heat through contacts", true},
        s.conductivity);
  visit(Key{"temperature", "K", {0.0, 5000.0}, "of the particles at the start"}, s.temperature);
  visit(Key{"tracer_temperature", "K", {0.0, 5000.0}, "of the tracer at the start; as the rest where absent"},
        s.tracerTemperature);
  visit(Key{"wall_temperature", "K", {0.0, 5000.0}, "of side walls and distributor; adiabatic where absent"},
        s.wallTemperature);
  visit(Key{"youngs_modulus", "Pa", positive,
            "of the real solid, which makes contacts as wide as it would; as wide as overlaps where absent"},
        s.youngsModulus);
  visit(Key{"poisson_ratio", "", {0.0, 0.5}, "of the real solid, beside youngs_modulus"}, s.poissonRatio);
  visit(Key{"gas", "", {}, "the gas; needed with [gas], and only then"}, s.gas);
}

std::vector<Contradiction> contradictions(const Scene& scene, const HeatSettings& heat);

/// The longest, s, that heat through contacts may take for a step: half the time in which a particle with six
/// contacts, each of the largest overlap that limits.max_overlap allows, comes to its neighbours'
/// temperature. The scene must have heat.
double longestHeatStep(const Scene& scene);
/// What heat is said to be, in few words: heat capacity, and the Biot number h d / (6 k) in a packed bed at
/// the mean inflow. The scene must have heat.
std::string heatNote(const Scene& scene);

}  // namespace bedmix
