// SPDX-License-Identifier: MIT
#include "replay/tracer_choice.h"

#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

/// Eight particles in a row over a bed of width 0.8 m, each higher than the last.
Frame row() {
  Frame frame;
  for (int i = 0; i < 8; ++i) {
    frame.position.push_back({0.05f + 0.1f * static_cast<float>(i), 0.01f * static_cast<float>(i)});
    frame.velocity.push_back({static_cast<float>(i), 0.0f});
    frame.id.push_back(10 + i);
    frame.species.push_back(static_cast<std::uint8_t>(i == 2));
  }
  return frame;
}

Scene wide() {
  Scene scene = test::syntheticScene(false, false, 8);
  scene.bed.width = 0.8;
  return scene;
}

std::vector<std::uint8_t> tags(const std::string& rule) {
  const auto choice = TracerChoice::parse(rule);
  EXPECT_TRUE(choice) << rule;
  const auto tags = choice->tag(row(), wide());
  EXPECT_TRUE(tags) << rule;
  return *tags;
}

using Tags = std::vector<std::uint8_t>;

TEST(TracerChoice, TagsByRulePartsAndExpression) {
  EXPECT_EQ(tags("left-half"), (Tags{1, 1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(tags("upper-half"), (Tags{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(tags("strips=4"), (Tags{1, 1, 0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(tags("layers=2"), (Tags{1, 1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(tags("layers=8"), (Tags{1, 0, 1, 0, 1, 0, 1, 0}));
  EXPECT_EQ(tags("x > width/2 && y < 0.055"), (Tags{0, 0, 0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(tags("species == 1 || id == 17"), (Tags{0, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(tags("fed"), (Tags{1, 1, 1, 1, 1, 1, 1, 1}));  // those at the start were 0 to 7
  EXPECT_EQ(tags("vx >= 6"), (Tags{0, 0, 0, 0, 0, 0, 1, 1}));
}

TEST(TracerChoice, RefusesWhatItCannotUse) {
  for (const char* rule :
       {"", "left", "strips=1", "strips=2000", "strips=x", "x <", "radius > 1", "(((", "x = 3 = y"})
    EXPECT_FALSE(TracerChoice::parse(rule)) << rule;
  EXPECT_FALSE(TracerChoice::parse("sqrt(0 - x)")->tag(row(), wide())) << "is no number";
}

TEST(Retagging, ColoursStayWithTheParticlesThatCarryThem) {
  const Frame then = row();
  const Retagging retagging(then, tags("left-half"));
  EXPECT_EQ(retagging.applied(then).species, tags("left-half"));

  Frame later = row();  // the first has gone, another has come
  later.position.erase(later.position.begin());
  later.velocity.erase(later.velocity.begin());
  later.id = {11, 12, 13, 14, 15, 16, 40};
  later.species.assign(7, 1);
  EXPECT_EQ(retagging.applied(later).species, (Tags{1, 1, 1, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace bedmix
