// SPDX-License-Identifier: MIT
#include "tests/hard/hard_case.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <string>

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

TEST(HardCases, StandInTheDocs) {
  std::ifstream page(BEDMIX_SOURCE_DIR "/assets/docs/hard-cases.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  for (const HardCase& c : hardCases())
    EXPECT_NE(text.find("| " + c.name + " |"), std::string::npos) << c.name << ": run tests/hard/table.sh";
}

INSTANTIATE_TEST_SUITE_P(Cases, Hard, testing::ValuesIn(hardCases()), [](const auto& tried) {
  std::string name;
  for (const char c : tried.param.name)
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name;
});

}  // namespace
}  // namespace bedmix::hard
