// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace bedmix {
namespace {

// Line numbers below count from the first line of this text.
const std::string validScene = R"(title = "test"
[bed]
width = 0.048
height = 0.12
thickness = 0.004
[particles]
count = 60
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 2000.0
restitution = 0.9
[time]
duration = 0.05
step = 1e-5
[gas]
step = 1e-4
[gas.grid]
columns = [[4, 0.012]]
rows = [[10, 0.012]]
[[gas.inlets]]
from = 0.0
to = 0.048
velocity_umf = 2.0
[flux]
x = 0.024
to = 0.04
)";

/// The valid scene with one line replaced, counted from 1.
std::string withLine(int number, const std::string& replacement) {
  std::size_t begin = 0;
  for (int i = 1; i < number; ++i) begin = validScene.find('\n', begin) + 1;
  const std::size_t end = validScene.find('\n', begin);
  return validScene.substr(0, begin) + replacement + validScene.substr(end);
}

std::vector<std::string> problemsOf(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::vector<std::string> texts;
  for (const Diagnostic& d : readScene(text, "s.toml", overrides).problems) texts.push_back(toString(d));
  return texts;
}

void expectOnly(const std::vector<std::string>& problems, const std::string& where, const std::string& what) {
  ASSERT_EQ(problems.size(), 1u) << ::testing::PrintToString(problems);
  EXPECT_TRUE(problems[0].starts_with(where + ": ")) << problems[0];
  EXPECT_NE(problems[0].find(what), std::string::npos) << problems[0];
}

TEST(SceneReader, ReadsEveryValue) {
  const auto scene = readScene(validScene, "some/where/s.toml");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->name, "s");
  EXPECT_EQ(scene->title, "test");
  EXPECT_EQ(scene->particles.count, 60);
  EXPECT_EQ(scene->bed.width, 0.048);
  EXPECT_EQ(scene->contacts.restitution, 0.9);
  EXPECT_FALSE(scene->contacts.damping);
  EXPECT_FALSE(scene->contacts.friction);
  ASSERT_TRUE(scene->gas);
  EXPECT_EQ(scene->gas->grid.rows.at(0).count, 10);
  EXPECT_EQ(scene->gas->inlets.at(0).velocityUmf, 2.0);
  EXPECT_EQ(scene->gas->density, 1.205);
}

TEST(SceneReader, TakesWholeNumbersForNumbers) {
  const auto scene = readScene(withLine(9, "density = 1500"), "s.toml");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->particles.density, 1500.0);
}

TEST(SceneReader, SyntaxErrorHasItsPlace) {
  expectOnly(problemsOf(withLine(7, "count = = 60")), "s.toml:7:9", "not TOML");
  expectOnly(problemsOf(withLine(8, "count = 61")), "s.toml:8:9", "redefine");
}

TEST(SceneReader, UnknownKeyNamesTheOneThatWasMeant) {
  expectOnly(problemsOf(withLine(9, "density = 1500.0\n  colour = 1")), "s.toml:10:3",
             "unknown key \"colour\" in [particles]; known here: count, diameter, density");
  expectOnly(problemsOf(withLine(17, "stpe = 1e-4")), "s.toml:17:1",
             "unknown key \"stpe\" in [gas]; did you mean \"step\"?");
  expectOnly(problemsOf(withLine(17, "friction = 0.3")), "s.toml:17:1", "did you mean [contacts.friction]?");
  expectOnly(problemsOf(withLine(5, "thickness = 0.004\ndiameter = 0.004")), "s.toml:6:1",
             "it belongs in [particles]");
  expectOnly(problemsOf(validScene + "[gaz]\nstep = 1"), "s.toml:28:2", "did you mean \"gas\"?");
}

TEST(SceneReader, WrongTypeSaysWhatItIsAndWhatIsWanted) {
  expectOnly(problemsOf(withLine(7, "count = \"many\"")), "s.toml:7:9",
             "particles.count must be a whole number, not the text \"many\"");
  expectOnly(problemsOf(withLine(7, "count = 60.5")), "s.toml:7:9", "a whole number, not the number 60.5");
  expectOnly(problemsOf(withLine(8, "diameter = true")), "s.toml:8:12", "a number, not true");
  expectOnly(problemsOf(withLine(19, "columns = [4, 0.012]")), "s.toml:19:12", "[count, size] pairs");
  expectOnly(problemsOf("title = 1979-05-27\n" + withLine(1, "")), "s.toml:1:9",
             "a text, not a date or time");
  expectOnly(problemsOf("flux = 3\n" + validScene.substr(0, validScene.find("[flux]"))), "s.toml:1:8",
             "flux must be a table, not the number 3");
}

TEST(SceneReader, RangeNamesTheUnit) {
  expectOnly(problemsOf(withLine(8, "diameter = -0.004")), "s.toml:8:12",
             "particles.diameter is -0.004 m; it must be above 0 m (diameter of the spheres)");
  expectOnly(problemsOf(withLine(12, "restitution = 1.5")), "s.toml:12:15", "above 0 and at most 1");
  expectOnly(problemsOf(withLine(9, "density = nan")), "s.toml:9:11", "a finite number");
  expectOnly(problemsOf(withLine(9, "density = inf")), "s.toml:9:11", "a finite number");
  expectOnly(problemsOf(withLine(7, "count = -1")), "s.toml:7:9", "from 0 to 1");
  expectOnly(problemsOf(withLine(19, "columns = [[0, 0.012]]")), "s.toml:19:13", "gas.grid.columns.0");
}

TEST(SceneReader, ReadsPictures) {
  const auto scene = readScene(validScene +
                                   "[pictures]\nlayers = [\"hud\", \"gas-speed\"]\ncolor = \"strips\"\n"
                                   "classes = 6\nbackground = \"#102aFf\"\ntrails = [0, 59]\n",
                               "s.toml");
  ASSERT_TRUE(scene && scene->pictures);
  EXPECT_EQ(scene->pictures->layers, (Layers{Layer::gasSpeed, Layer::hud}));
  EXPECT_EQ(scene->pictures->color, ParticleColor::strips);
  EXPECT_EQ(scene->pictures->classes, 6);
  EXPECT_EQ(scene->pictures->ground, (Rgba{16, 42, 255}));
  EXPECT_EQ(scene->pictures->trails, (std::vector<std::int64_t>{0, 59}));
  EXPECT_FALSE(readScene(validScene, "s.toml")->pictures);
}

TEST(SceneReader, WrongPicturesHaveTheirPlace) {
  const std::string begin = validScene + "[pictures]\n";  // the 29th line follows
  expectOnly(problemsOf(begin + "layers = [\"walls\", \"particels\"]"), "s.toml:29:20",
             "pictures.layers.1 has no \"particels\"; did you mean \"particles\"?");
  expectOnly(problemsOf(begin + "layers = \"walls\""), "s.toml:29:10", "must be a list of names");
  expectOnly(problemsOf(begin + "color = \"sped\""), "s.toml:29:9", "did you mean \"speed\"?");
  expectOnly(problemsOf(begin + "background = \"#12345\""), "s.toml:29:14", "a colour like");
  expectOnly(problemsOf(begin + "background = \"#12345g\""), "s.toml:29:14", "a colour like");
  expectOnly(problemsOf(begin + "trails = [1.5]"), "s.toml:29:11", "a whole number");
  expectOnly(problemsOf(begin + "trails = [-1]"), "s.toml:29:11", "from 0");
  expectOnly(problemsOf(begin + "color = \"spin\""), "s.toml:29:9", "no [contacts.friction]");
  expectOnly(problemsOf(begin + "colour = \"spin\""), "s.toml:29:1", "did you mean \"color\"?");
}

TEST(SceneReader, MissingKeysAreReportedAtTheirTable) {
  expectOnly(problemsOf(withLine(8, "")), "s.toml:6:1", "[particles] lacks the key \"diameter\"");
  expectOnly(problemsOf(withLine(22, "")), "s.toml:21:1", "[gas.inlets.0] lacks the key \"from\"");
  const auto empty = problemsOf("");
  EXPECT_EQ(empty.size(), 4u) << ::testing::PrintToString(empty);
  EXPECT_NE(empty.at(0).find("the scene lacks the table [bed]"), std::string::npos);
}

TEST(SceneReader, UnknownModelPrintsTheTable) {
  const auto problems = problemsOf(withLine(17, "drag = \"ergunn\""));
  expectOnly(problems, "s.toml:17:8", "gas.drag has no \"ergunn\"; did you mean \"ergun\"?");
  for (const ModelInfo& law : modelTable<DragLaw>)
    EXPECT_NE(problems[0].find(std::string(law.name) + ' '), std::string::npos) << law.name;
}

TEST(SceneReader, AllProblemsAtOnceInTheOrderOfTheFile) {
  std::string text = withLine(8, "diameter = \"4 mm\"\nmass = 1.0");
  text.replace(text.find("velocity_umf"), 12, "velocity_unf");
  text.replace(text.find("width = 0.048"), 13, "width = -1.0 ");
  const auto problems = problemsOf(text);
  ASSERT_EQ(problems.size(), 4u) << ::testing::PrintToString(problems);
  EXPECT_TRUE(problems[0].starts_with("s.toml:3:9: bed.width"));
  EXPECT_TRUE(problems[1].starts_with("s.toml:8:12: particles.diameter"));
  EXPECT_TRUE(problems[2].starts_with("s.toml:9:1: unknown key \"mass\""));
  EXPECT_TRUE(problems[3].starts_with("s.toml:25:1: unknown key \"velocity_unf\""));
}

TEST(SceneReader, OverridesAreAppliedBeforeChecking) {
  const auto scene = readScene(validScene, "s.toml",
                               {{"gas.step", "2e-4"},
                                {"contacts.friction.coefficient", "0.5"},
                                {"gas.drag", "ergun"},
                                {"gas.inlets.0.velocity_umf", "3"},
                                {"title", "Half speed"}});
  ASSERT_TRUE(scene) << toString(scene.problems.at(0));
  EXPECT_EQ(scene->gas->step, 2e-4);
  EXPECT_EQ(scene->contacts.friction.value().coefficient, 0.5);
  EXPECT_EQ(scene->gas->drag, DragLaw::ergun);
  EXPECT_EQ(scene->gas->inlets.at(0).velocityUmf, 3.0);
  EXPECT_EQ(scene->title, "Half speed");
}

TEST(SceneReader, RefusesWhatIsTooLongToBeAScene) {
  std::string inlets;
  for (int i = 0; i < 1001; ++i) inlets += "{},";
  expectOnly(problemsOf(validScene, {{"gas.inlets", '[' + inlets + ']'}}), "--set gas.inlets",
             "has 1001 elements; at most 1000 are read");
  expectOnly(problemsOf(validScene + std::string(65536, '#')), "s.toml", "a scene has at most 65536");
}

TEST(SceneReader, RefusesTablesDeeperThanTheStack) {
  std::string bare = "a", quoted = "'a'";
  for (int i = 0; i < 32000; ++i) bare += ".a";
  for (int i = 0; i < 9000; ++i) quoted += " . \"a\"";
  for (const std::string& key : {bare + " = 1\n", '[' + bare + "]\n", quoted + " = 1\n"})
    EXPECT_NE(problemsOf("# a remark\n" + key).at(0).find("more than 64 parts"), std::string::npos);
  expectOnly(problemsOf("x = 1\n" + bare), "s.toml:2:128", "more than 64 parts");
  expectOnly(problemsOf(validScene, {{bare, "1"}}), "--set " + bare, "more than 64 parts");
  const std::string dots(100, '.');
  EXPECT_TRUE(readScene("# dots " + dots + " and on\n" + validScene, "s.toml"));
}

TEST(SceneReader, EmptyOverrideRemoves) {
  const auto scene = readScene(validScene, "s.toml",
                               {{"contacts.restitution", ""}, {"contacts.damping", "0.17"}, {"gas", ""}});
  ASSERT_TRUE(scene) << toString(scene.problems.at(0));
  EXPECT_EQ(scene->contacts.damping, 0.17);
  EXPECT_FALSE(scene->gas);
}

TEST(SceneReader, OverridesAreNamedInMessages) {
  expectOnly(problemsOf(validScene, {{"gas.stepp", "1e-4"}}), "--set gas.stepp", "did you mean \"step\"?");
  expectOnly(problemsOf(validScene, {{"gas.step", "fast"}}), "--set gas.step", "not the text \"fast\"");
  expectOnly(problemsOf(validScene, {{"gas.step", "[1"}}), "--set gas.step", "is not a TOML value");
  expectOnly(problemsOf(validScene, {{"gas.inlets.7.from", "0.0"}}), "--set gas.inlets.7.from", "\"7\"");
  expectOnly(problemsOf(validScene, {{"bed.width.x", "1"}}), "--set bed.width.x", "\"width\"");
  expectOnly(problemsOf(validScene, {{"bed..x", "1"}}), "--set bed..x", "dots between them");
  expectOnly(problemsOf(validScene, {{"gas.density", "1.2"}, {"gas.step", "fast"}}), "--set gas.step",
             "fast");
  expectOnly(problemsOf(validScene, {{"time.duration", "x", "--until"}}), "--until", "time.duration");
  expectOnly(problemsOf(withLine(26, ""), {{"flux.x", "0.001"}}), "--set flux.x", "leaves the bed");
}

TEST(SceneReader, OverrideThatOpensATableIsNamedForWhatTheTableLacks) {
  const std::string noFlux = validScene.substr(0, validScene.find("[flux]"));
  expectOnly(problemsOf(noFlux, {{"flux.to", "0.04"}}), "--set flux.to", "[flux] lacks the key \"x\"");
}

}  // namespace
}  // namespace bedmix
