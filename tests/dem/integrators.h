// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace bedmix {

/// All that a scene can name.
inline std::vector<Integrator> allIntegrators() {
  std::vector<Integrator> all;
  for (std::size_t i = 0; i < modelTable<Integrator>.size(); ++i) all.push_back(static_cast<Integrator>(i));
  return all;
}
inline auto eachIntegrator() { return testing::ValuesIn(allIntegrators()); }
inline std::string nameOfIntegrator(const testing::TestParamInfo<Integrator>& tried) {
  std::string name(modelName(tried.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace bedmix
