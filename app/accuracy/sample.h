// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

namespace bedmix {

/// What a sample is of.
enum class Panel { timing, contact, drift, divergence, trajectory, statistics };
inline constexpr std::array<std::string_view, 6> panelNames{"timing",     "contact",    "drift",
                                                            "divergence", "trajectory", "statistics"};

/// A measured quantity: a column of accuracy.csv.
struct Measure {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
};
namespace measure {
inline constexpr Measure wall{"wall", "s", "wall time of a stretch of the scene"};
inline constexpr Measure standardWall{"standard_wall", "s", "the same of `standard`, just before and after"};
inline constexpr Measure simulated{"simulated", "s", "simulated time"};
inline constexpr Measure steps{"steps", "1/s", "particle steps per simulated s"};
inline constexpr Measure gasSteps{"gas_steps", "1/s", "gas steps per simulated s"};
inline constexpr Measure demWall{"dem_wall", "s",
                                 "wall time of particles alone, per particle and simulated s"};
inline constexpr Measure interior{"interior_error", "", "within a contact, against the damped oscillator"};
inline constexpr Measure restitution{"restitution_error", "", "rms over phases, against the closed form"};
inline constexpr Measure worstRestitution{"restitution_worst", "", "the largest over phases"};
inline constexpr Measure duration{"duration_error", "", "of a contact, relative, rms"};
inline constexpr Measure oblique{"oblique_error", "", "tangential impulse in full sliding, relative, rms"};
inline constexpr Measure drift{"energy_drift", "", "change of energy in an elastic box, relative"};
inline constexpr Measure growth{"growth_rate", "1/s", "of the distance of twin runs"};
inline constexpr Measure predictable{"predictable", "s", "until 1e-6 of a diameter has become a tenth"};
inline constexpr Measure horizon{"horizon", "s", "at which trajectories are compared"};
inline constexpr Measure position{
    "position_error", "d", "distance from its place in the reference that half of the particles exceed"};
inline constexpr Measure mixingTime{"mixing_time", "s", "first A >= 0.9"};
inline constexpr Measure ashton{"ashton_mean", "", "mean A"};
inline constexpr Measure lacey{"lacey_mean", "", "mean M"};
inline constexpr Measure pressureDrop{"pressure_drop", "Pa", "mean"};
inline constexpr Measure pressureSd{"pressure_sd", "Pa", "standard deviation"};
inline constexpr Measure pressureFrequency{"pressure_frequency", "Hz", "centre of the spectrum"};
inline constexpr Measure bedHeight{"bed_height", "m", "mean"};
inline constexpr Measure flux{"flux", "kg/(m2 s)", "mean"};
inline constexpr Measure speed{"speed", "m/s", "root mean square over particles and time"};
inline constexpr Measure massResidual{"mass_residual", "", "largest of the gas, relative to the inflow"};
inline constexpr Measure notConverged{"not_converged", "", "share of gas steps that met the iteration limit"};
inline constexpr Measure overlap{"largest_overlap", "d", "deepest contact"};
}  // namespace measure

/// All columns in their order.
inline constexpr std::array measures{measure::wall,
                                     measure::standardWall,
                                     measure::simulated,
                                     measure::steps,
                                     measure::gasSteps,
                                     measure::demWall,
                                     measure::interior,
                                     measure::restitution,
                                     measure::worstRestitution,
                                     measure::duration,
                                     measure::oblique,
                                     measure::drift,
                                     measure::growth,
                                     measure::predictable,
                                     measure::horizon,
                                     measure::position,
                                     measure::mixingTime,
                                     measure::ashton,
                                     measure::lacey,
                                     measure::pressureDrop,
                                     measure::pressureSd,
                                     measure::pressureFrequency,
                                     measure::bedHeight,
                                     measure::flux,
                                     measure::speed,
                                     measure::massResidual,
                                     measure::notConverged,
                                     measure::overlap};

/// Which sample: no two finished ones have the same key.
struct SampleKey {
  Panel panel{};
  std::string setting;
  std::string reference;  // of a trajectory; else empty
  int index = 0;          // repetition, or what is added to the scene's seed

  auto operator<=>(const SampleKey&) const = default;
};

/// One finished measurement.
struct Sample {
  SampleKey key;
  std::string failure;                        // why and when it became invalid; empty where it did not
  std::map<std::string_view, double> values;  // by the names of measures; what is undefined is not there

  void set(const Measure& m, double value) { values[m.name] = value; }
};

}  // namespace bedmix
