// SPDX-License-Identifier: MIT
#include "tests/hard/hard_case.h"

namespace bedmix::hard {

std::vector<HardCase> hardCases() {
  std::vector<HardCase> all;
  for (const auto& cases :
       {contactCases(), stepCases(), restCases(), cornerCases(), fixedBedCases(), movingBedCases()})
    all.insert(all.end(), cases.begin(), cases.end());
  return all;
}

}  // namespace bedmix::hard
