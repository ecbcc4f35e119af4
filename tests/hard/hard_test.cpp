// SPDX-License-Identifier: MIT
#include "tests/hard/hard_case.h"

#include <gtest/gtest.h>

#include <cctype>

namespace bedmix::hard {
namespace {

class Hard : public testing::TestWithParam<HardCase> {};

TEST_P(Hard, StaysWithinItsBounds) {
  const std::vector<Check> checks = GetParam().run();
  EXPECT_FALSE(checks.empty());
  for (const Check& check : checks)
    EXPECT_TRUE(check.holds()) << check.invariant << ": " << check.measured << ", at most " << check.bound
                               << " (" << check.from << ")";
}

INSTANTIATE_TEST_SUITE_P(Cases, Hard, testing::ValuesIn(hardCases()), [](const auto& tried) {
  std::string name;
  for (const char c : tried.param.name)
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name;
});

}  // namespace
}  // namespace bedmix::hard
