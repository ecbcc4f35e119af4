// SPDX-License-Identifier: MIT
#include "app/accuracy/findings.h"

#include "app/accuracy/tables.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

constexpr double duration = 10.0;

/// A study of four presets with statistics of one observable.
class Study4 : public testing::Test {
 protected:
  Study4() {
    for (const char* name : {"draft", "standard", "paper", "reference"}) {
      design_.settings.push_back({"accuracy=" + std::string(name), {}});
      design_.presets.push_back(design_.settings.back().name);
      design_.statistics.push_back(design_.settings.back().name);
    }
  }

  void cost(const std::string& preset, double ratio) {
    for (int k = 0; k < 3; ++k) {
      Sample s{{Panel::timing, "accuracy=" + preset, "", k}, {}, {}};
      s.set(measure::standardWall, 0.1 * (1 + k));
      s.set(measure::wall, ratio * 0.1 * (1 + k));
      s.set(measure::simulated, 0.2);
      samples_.push_back(s);
    }
  }
  void mixing(const std::string& preset, const std::vector<double>& times, double simulated = duration) {
    for (std::size_t k = 0; k < times.size(); ++k) {
      Sample s{{Panel::statistics, "accuracy=" + preset, "", static_cast<int>(k)}, {}, {}};
      s.set(measure::mixingTime, times[k]);
      s.set(measure::simulated, simulated);
      samples_.push_back(s);
    }
  }
  Findings findings() const { return Findings(design_, samples_, duration); }
  std::string verdict() const { return verdictOf(design_, findings()); }

  Design design_;
  std::vector<Sample> samples_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Study4, CostsAreRatiosOfNeighbouringTimes) {
  cost("standard", 1.0);
  cost("paper", 5.0);
  EXPECT_NEAR(*findings().of("accuracy=paper").cost, 5.0, 1e-12);
  EXPECT_NEAR(*findings().standardSpeed(), 1.0, 1e-12);
  EXPECT_FALSE(findings().of("accuracy=draft").cost);
}

TEST_F(Study4, WhatNoiseHidesIsNoGain) {
  for (const auto& [preset, ratio] :
       {std::pair{"draft", 0.5}, {"standard", 1.0}, {"paper", 6.0}, {"reference", 8.0}})
    cost(preset, ratio);
  mixing("reference", {3.0, 3.5, 4.0, 3.2, 3.6, 3.4});
  mixing("standard", {3.1, 3.4, 3.9, 3.3});
  mixing("paper", {3.3, 3.6, 3.8, 2.9});
  mixing("draft", {2.0, 2.01, 1.99, 2.0, 2.0, 2.02});
  const std::string said = verdict();
  EXPECT_TRUE(has(said, "costs 6 x accuracy=standard for no measurable gain")) << said;
  EXPECT_TRUE(has(said, "cannot be told from noise")) << said;
  EXPECT_TRUE(has(said, "It would take about")) << said;
  EXPECT_TRUE(has(said, "in nothing told apart from accuracy=reference is accuracy=standard (cost 1)"))
      << said;
  EXPECT_TRUE(has(said, "accuracy=draft: cost 0.5; told apart from accuracy=reference in mixing time"))
      << said;
}

TEST_F(Study4, AGainIsNamed) {
  for (const auto& [preset, ratio] :
       {std::pair{"draft", 0.5}, {"standard", 1.0}, {"paper", 6.0}, {"reference", 8.0}})
    cost(preset, ratio);
  mixing("reference", {3.000, 3.001, 2.999, 3.0});
  mixing("paper", {3.001, 3.002, 3.0, 3.001});
  mixing("standard", {3.2, 3.201, 3.199, 3.2});
  const std::string said = verdict();
  EXPECT_TRUE(has(said, "For 1 % in mixing time you need accuracy=paper (cost 6)")) << said;
  EXPECT_FALSE(has(said, "no measurable gain")) << said;
  EXPECT_TRUE(has(said, "accuracy=standard: cost 1; told apart")) << said;
}

TEST_F(Study4, RunsOfAnotherLengthAreNotMixedIn) {
  mixing("standard", {3.0, 3.1, 3.2});
  mixing("standard", {9.0, 9.1, 9.2}, 0.4 * duration);
  EXPECT_EQ(findings().of("accuracy=standard").runs.at(measure::mixingTime.name).size(), 3u);
}

TEST_F(Study4, AnUnstableSettingIsARow) {
  samples_.push_back({{Panel::statistics, "accuracy=draft", "", 0}, "particle 7 overlaps at t = 0.31 s", {}});
  samples_.back().set(measure::simulated, 0.31);
  const std::string tables = tablesOf(design_, findings());
  EXPECT_TRUE(has(tables, "fails: accuracy=draft\n  particle 7 overlaps at t = 0.31 s")) << tables;
  EXPECT_FALSE(has(verdict(), "draft: cost"));
}

TEST_F(Study4, UnstableInABoxButNotInTheSceneIsSaid) {
  cost("draft", 0.5);
  samples_.push_back({{Panel::drift, "accuracy=draft", "", 0}, "particle 7 overlaps at t = 1.5 s", {}});
  const Findings found = findings();
  EXPECT_TRUE(found.of("accuracy=draft").failure.empty());
  const std::string tables = tablesOf(design_, found);
  EXPECT_TRUE(has(tables, "unstable in an elastic box: accuracy=draft\n  particle 7 overlaps at t = 1.5 s"))
      << tables;
}

TEST_F(Study4, OrdersAreFittedByKnob) {
  Sweep sweep{"time.step, test", "s", "accuracy=reference", {}};
  double step = 1e-5;
  for (const char* name : {"draft", "standard", "paper"}) {
    const std::string setting = "accuracy=" + std::string(name);
    Sample contact{{Panel::contact, setting, "", 0}, {}, {}};
    contact.set(measure::restitution, 1e-3 * (step / 1e-5) * (step / 1e-5));
    samples_.push_back(contact);
    Sample path{{Panel::trajectory, setting, sweep.reference, 0}, {}, {}};
    path.set(measure::position, 1e-4 * step / 1e-5);
    path.set(measure::horizon, 0.01);
    samples_.push_back(path);
    sweep.turns.push_back({step, setting});
    step *= 2.0;
  }
  design_.sweeps.push_back(sweep);
  const Findings found = findings();
  ASSERT_EQ(found.orders().size(), 3u);
  EXPECT_FALSE(found.orders()[0].order);  // within a contact: not measured
  EXPECT_NEAR(found.orders()[1].order->value, 2.0, 1e-9);
  EXPECT_NEAR(found.orders()[2].order->value, 1.0, 1e-9);
  EXPECT_TRUE(has(tablesOf(design_, found), "time.step, test"));
}

}  // namespace
}  // namespace bedmix
