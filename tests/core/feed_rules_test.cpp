// SPDX-License-Identifier: MIT
#include "tests/core/spoiled_scene.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

constexpr const char* soundFeed = R"(
[bed]
width = 0.1
height = 0.2
thickness = 0.004
[particles]
count = 10
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 2000.0
restitution = 0.9
[time]
duration = 0.1
step = 1e-5
[tracer]
rule = "fed"
[feed]
most = 20
[[feed.streams]]
rate = 100.0
from = 0.0
to = 0.02
y = 0.15
[[feed.outlets]]
from = 0.08
to = 0.1
bottom = 0.0
top = 0.05
)";

Scene fedScene() {
  Result<Scene> scene = readScene(soundFeed, "");
  EXPECT_TRUE(scene) << (scene ? "" : scene.problems.front().message);
  return scene ? *scene : Scene();
}
FeedSettings& feed(Scene& s) { return *s.effects.at<FeedSettings>(); }

class FeedRules : public testing::TestWithParam<test::Spoiled> {};

TEST_P(FeedRules, AreReportedOnce) { test::expectReportedOnce(fedScene(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Each, FeedRules,
    testing::Values(test::Spoiled{"NothingComesOrGoes",
                                  [](Scene& s) {
                                    s.tracer.rule = TracerRule::leftHalf;
                                    feed(s).streams.clear();
                                    feed(s).outlets.clear();
                                  },
                                  "feed", "nobody comes or goes"},
                    test::Spoiled{"TracerOfNobody", [](Scene& s) { feed(s).streams.clear(); }, "tracer.rule",
                                  "nobody is fed"},
                    test::Spoiled{"MoreAtTheStartThanAtMost", [](Scene& s) { feed(s).most = 5; }, "feed.most",
                                  "begins with 10"},
                    test::Spoiled{"StreamOfNoKind", [](Scene& s) { feed(s).streams[0].species = "sand"; },
                                  "feed.streams.0.species", "no kind of particles called \"sand\""},
                    test::Spoiled{"StreamTooNarrow", [](Scene& s) { feed(s).streams[0].to = 0.003; },
                                  "feed.streams.0.to", "no room for a particle"},
                    test::Spoiled{"StreamBesideTheBed", [](Scene& s) { feed(s).streams[0].to = 0.2; },
                                  "feed.streams.0.to", "the bed ends at 0.1 m"},
                    test::Spoiled{"StreamAboveTheLid",
                                  [](Scene& s) {
                                    s.bed.top = BedTop::lid;
                                    feed(s).streams[0].y = 0.25;
                                  },
                                  "feed.streams.0.y", "above the lid"},
                    test::Spoiled{"TemperatureWithoutHeat",
                                  [](Scene& s) { feed(s).streams[0].temperature = 300.0; },
                                  "feed.streams.0.temperature", "no [heat]"},
                    test::Spoiled{"StreamWithinAnOutlet",
                                  [](Scene& s) {
                                    feed(s).outlets[0] = {.from = 0.01, .to = 0.1, .bottom = 0.1, .top = 0.2};
                                  },
                                  "feed.streams.0.y", "takes them out at once"},
                    test::Spoiled{"OutletWithoutWidth", [](Scene& s) { feed(s).outlets[0].to = 0.08; },
                                  "feed.outlets.0.to", "right of the left one"},
                    test::Spoiled{"OutletWithoutHeight", [](Scene& s) { feed(s).outlets[0].top = 0.0; },
                                  "feed.outlets.0.top", "above the lower one"}),
    test::nameOfSpoiled);

}  // namespace
}  // namespace bedmix
