// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/design.h"
#include "app/accuracy/interval.h"
#include "app/accuracy/line_fit.h"
#include "app/accuracy/sample.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What follows from the samples of a study.

namespace bedmix {

/// What a run is judged by, as a person would call it.
struct Observable {
  const Measure& of;
  std::string_view title;
  bool relative;  // differences are given over the reference's mean, which is not about zero
};
inline constexpr std::array observables{Observable{measure::mixingTime, "mixing time", true},
                                        Observable{measure::ashton, "mean A", false},
                                        Observable{measure::pressureDrop, "pressure drop", true},
                                        Observable{measure::pressureSd, "its deviation", true},
                                        Observable{measure::pressureFrequency, "its frequency", true},
                                        Observable{measure::bedHeight, "bed height", true},
                                        Observable{measure::speed, "speed", true},
                                        Observable{measure::flux, "flux", false}};

/// One setting's.
struct Finding {
  std::string setting;
  std::string failure;                                   // of its first run that did not last
  std::string boxFailure;                                // of the elastic box, which scenes need not share
  std::optional<double> cost;                            // wall time over that of `standard`, median
  std::map<std::string_view, double> numbers;            // by measure: contacts, drift, dem_wall: medians
  std::map<std::string, double> trajectories;            // by reference: position errors, medians
  std::map<std::string_view, std::vector<double>> runs;  // by measure: a value a run
};

/// How two settings differ in an observable: in the other's mean, or in the observable's unit.
std::optional<Estimate> differenceOf(const Finding& one, const Finding& other, const Observable& observable,
                                     double risk = usualRisk);

struct FittedOrder {
  std::string knob;
  std::string_view of;  // "a whole contact", ...
  std::optional<Order> order;
};

class Findings {
 public:
  /// Statistics are those of runs over `duration` s and of runs that failed.
  Findings(const Design& design, const std::vector<Sample>& samples, double duration);

  const std::vector<Finding>& all() const { return findings_; }
  const Finding& of(std::string_view setting) const;
  const std::vector<FittedOrder>& orders() const { return orders_; }
  std::optional<double> standardSpeed() const { return wall_; }  // wall s per simulated s
  std::optional<double> horizon() const { return horizon_; }     // s
  std::optional<double> growth() const { return growth_; }       // 1/s

 private:
  void fitOrders(const Design& design);

  std::vector<Finding> findings_;
  std::vector<FittedOrder> orders_;
  std::optional<double> wall_, horizon_, growth_;
};

}  // namespace bedmix
