// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Cases that break bed codes, each with a bound from theory. Program and tests run the same tables.

namespace bedmix::hard {

/// One row: what must hold, how far from it theory allows, and how far from it the case came.
struct Check {
  std::string invariant;
  double bound = 0.0;
  std::string from;  // what the bound follows from
  double measured = 0.0;

  bool holds() const { return measured <= bound; }  // false for what is no number
};

struct HardCase {
  std::string name;
  /// Throws std::runtime_error where the case cannot be taken to its end.
  std::vector<Check> (*run)();
};

std::vector<HardCase> contactCases();
std::vector<HardCase> stepCases();
std::vector<HardCase> restCases();
std::vector<HardCase> cornerCases();
std::vector<HardCase> fixedBedCases();
std::vector<HardCase> movingBedCases();

/// All of them, in the order of the table.
std::vector<HardCase> hardCases();

}  // namespace bedmix::hard
