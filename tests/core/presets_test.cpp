// SPDX-License-Identifier: MIT
#include "engine/core/presets.h"

#include <gtest/gtest.h>

#include <string>

namespace bedmix {
namespace {

std::string withSettings(const std::string& first, const std::string& ofTime, const std::string& ofGas) {
  return first + R"(
[bed]
width = 0.048
height = 0.12
[particles]
count = 60
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 2000.0
restitution = 0.9
[time]
duration = 0.05
)" + ofTime +
         "\n" + (ofGas == "none" ? "" : "[gas]\n" + ofGas + R"(
[gas.grid]
columns = [[4, 0.012]]
rows = [[10, 0.012]]
[[gas.inlets]]
from = 0.0
to = 0.048
velocity_umf = 2.0
)");
}

std::string problemIn(const std::string& text, const std::vector<Override>& overrides = {}) {
  const auto scene = readScene(text, "s.toml", overrides);
  return scene.problems.size() == 1 ? toString(scene.problems[0]) : std::to_string(scene.problems.size());
}

TEST(Presets, GiveAllTheSameKeys) {
  ASSERT_EQ(presets.size(), modelTable<Accuracy>.size());
  for (const Preset& preset : presets)
    for (std::size_t k = 0; k < preset.size(); ++k) EXPECT_EQ(preset[k].path, presets.front()[k].path);
}

TEST(Presets, AllFitTheBundledParticles) {
  for (const ModelInfo& model : modelTable<Accuracy>)
    for (const char* gas : {"", "none"})
      EXPECT_TRUE(readScene(withSettings("accuracy = \"" + std::string(model.name) + '"', "", gas), "s.toml"))
          << model.name;
}

TEST(Presets, GiveWhatTheSceneDoesNot) {
  const auto paper =
      readScene(withSettings("accuracy = \"paper\"", "step = 2e-5", "step = \"auto\""), "s.toml");
  ASSERT_TRUE(paper);
  EXPECT_EQ(paper->accuracy, Accuracy::paper);
  EXPECT_EQ(paper->time.integrator, Integrator::rk4);
  EXPECT_EQ(paper->gas->scheme, GasScheme::simple);
  EXPECT_EQ(paper->time.step, 2e-5);
  EXPECT_TRUE(paper->gas->step.isAutomatic());
}

TEST(Presets, OnTheCommandLineWinOverTheScene) {
  const std::string text =
      withSettings("accuracy = \"paper\"", "step = 2e-5", "step = 1e-4\ndrag = \"ergun\"");
  std::vector<Override> overrides = accuracyOverrides("standard");
  const auto scene = readScene(text, "s.toml", overrides);
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->time.step.isAutomatic());
  EXPECT_TRUE(scene->gas->step.isAutomatic());
  EXPECT_EQ(scene->gas->scheme, GasScheme::projection);
  EXPECT_EQ(scene->gas->drag, DragLaw::ergun);  // no numerics

  overrides.push_back({"time.step", "1e-5"});  // a later --set wins over that
  EXPECT_EQ(readScene(text, "s.toml", overrides)->time.step, 1e-5);
}

TEST(Presets, OpenNoTableOfTheirOwn) {
  EXPECT_FALSE(readScene(withSettings("accuracy = \"draft\"", "", "none"), "s.toml")->gas);
  EXPECT_FALSE(readScene(withSettings("", "", "none"), "s.toml", accuracyOverrides("paper"))->gas);
}

TEST(Presets, AreNamedForWhatDoesNotFit) {
  std::string text = withSettings("\naccuracy = \"paper\"", "", "none");
  text.replace(text.find("2000.0"), 6, "2.0e6 ");  // T/14 is 2.3e-6 s
  EXPECT_TRUE(problemIn(text).starts_with("s.toml:2:12: a step of 1e-05 s is T/3.15")) << problemIn(text);
  text.replace(text.find("paper"), 5, "draft");
  EXPECT_TRUE(problemIn(text, accuracyOverrides("paper")).starts_with("--accuracy: a step of 1e-05 s"));
  text = withSettings("", "", "");
  EXPECT_NE(problemIn(text, accuracyOverrides("papr")).find("did you mean \"paper\"?"), std::string::npos);
  EXPECT_NE(problemIn(withSettings("accuracy = 2", "", "")).find("must be a name in quotes"),
            std::string::npos);
}

TEST(AutomaticStep, IsANumberOrAuto) {
  const auto scene = readScene(withSettings("", "step = \"auto\"", "step = \"auto\""), "s.toml");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->time.step.isAutomatic());
  EXPECT_TRUE(scene->gas->step.isAutomatic());
  EXPECT_EQ(problemIn(withSettings("", "step = \"fast\"", "")),
            "s.toml:14:8: time.step must be a number or \"auto\", not the text \"fast\"");
  EXPECT_NE(problemIn(withSettings("", "", "step = -1")).find("must be above 0 s"), std::string::npos);
}

}  // namespace
}  // namespace bedmix
