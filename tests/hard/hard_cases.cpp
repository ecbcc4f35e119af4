// SPDX-License-Identifier: MIT
#include "tests/hard/hard_case.h"

#include <fmt/core.h>

#include <cstdio>
#include <exception>

using namespace bedmix::hard;

/// Prints the table of assets/docs/hard-cases.md; returns 1 where a bound is broken.
int main() {
  bool allHold = true;
  fmt::print("| case | must hold | bound | measured |\n| --- | --- | --- | --- |\n");
  for (const HardCase& c : hardCases()) {
    std::string name = c.name;
    try {
      for (const Check& check : c.run()) {
        allHold &= check.holds();
        fmt::print("| {} | {} | {:.3g}{} | {:.3g}{} |\n", name, check.invariant, check.bound,
                   check.from.empty() ? "" : " (" + check.from + ")", check.measured,
                   check.holds() ? "" : " **broken**");
        name.clear();
      }
    } catch (const std::exception& e) {
      allHold = false;
      fmt::print("| {} | | | **{}** |\n", name, e.what());
    }
    std::fflush(stdout);
  }
  return allHold ? 0 : 1;
}
