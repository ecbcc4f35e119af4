// SPDX-License-Identifier: MIT
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class Commands : public ProgramTest {};

TEST_F(Commands, VersionNamesTheCommit) {
  const Outcome o = bedmix({"--version"});
  EXPECT_EQ(o.exitCode, 0);
  EXPECT_TRUE(contains(o.out, "bedmix 0.1.0 ("));
  EXPECT_EQ(bedmix({"--version"}).out, o.out);
}

TEST_F(Commands, ScenesAreListedAndShown) {
  const auto scenes = nlohmann::json::parse(bedmix({"scenes", "--json"}).out);
  std::vector<std::string> names;
  for (const auto& scene : scenes) names.push_back(scene["name"]);
  for (const char* name : {"settling", "single-jet", "tian-2007-even", "tian-2007-inclined", "tiny"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_TRUE(contains(bedmix({"scenes"}).out, "tian-2007-even"));
  EXPECT_EQ(bedmix({"scenes", "show", "tiny"}).out, readFile(BEDMIX_SOURCE_DIR "/assets/scenes/tiny.toml"));
}

TEST_F(Commands, EveryBundledSceneIsValid) {
  for (const auto& scene : nlohmann::json::parse(bedmix({"scenes", "--json"}).out)) {
    const Outcome o = bedmix({"check", scene["name"], "--json"});
    ASSERT_EQ(o.exitCode, 0) << o.err;
    const auto report = nlohmann::json::parse(o.out);
    EXPECT_EQ(report["valid"], true);
    EXPECT_GT(report["effort"]["run time"]["value"], 0.0) << scene["name"];
    const auto& step = report["step margins"]["particle step"]["value"];
    if (step == "auto") continue;  // never above that
    EXPECT_GE(report["time scales"]["contact time scale T"]["value"].get<double>(),
              14.0 * step.get<double>());
  }
}

TEST_F(Commands, CheckSaysWhatThePaperSays) {
  const auto report = nlohmann::json::parse(bedmix({"check", "tian-2007-even", "--json"}).out);
  EXPECT_EQ(report["effects"]["gas"]["value"], "on");
  EXPECT_NEAR(report["gas"]["u_mf"]["value"], 1.289, 1e-3);                            // Tian et al. (2007)
  EXPECT_NEAR(report["time scales"]["contact time scale T"]["value"], 9.96e-4, 1e-6);  // Eq. (10)
  EXPECT_NEAR(report["gas"]["inlet 1"]["value"], 2.579, 1e-3);
}

TEST_F(Commands, CheckOfABedWithoutGravityHasNoUndefinedNumbers) {
  std::string text = readFile(BEDMIX_SOURCE_DIR "/assets/scenes/tiny.toml");
  const std::string inlet = "velocity_umf = 2.0";
  text.replace(text.find(inlet), inlet.size(), "velocity = 2.0");
  writeFile(folder / "free.toml", "gravity = 0.0\n" + text);
  const Outcome o = bedmix({"check", "free.toml", "--json"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_FALSE(contains(o.out, "null")) << o.out;
  EXPECT_EQ(nlohmann::json::parse(o.out)["gas"]["u_mf"]["value"], "none");
}

TEST_F(Commands, ResolvedSceneIsItsOwnResolution) {
  const Outcome once = bedmix({"check", "tiny", "--resolved"});
  ASSERT_EQ(once.exitCode, 0) << once.err;
  EXPECT_TRUE(contains(once.out, "integrator = \"velocity-verlet\""));
  writeFile(folder / "again.toml", once.out);
  EXPECT_EQ(bedmix({"check", "again.toml", "--resolved"}).out, once.out);
}

TEST_F(Commands, DoctorFindsWhatTheDemoNeeds) {
  const Outcome o = bedmix({"doctor", "--json"});
  EXPECT_EQ(o.exitCode, 0) << o.out;
  for (const auto& part : nlohmann::json::parse(o.out)) EXPECT_EQ(part["works"], true) << part;
}

// A library that cannot be opened hides the one of the system.
TEST_F(Commands, DrawWithWhatIsThere) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out"}).exitCode, 0);
  fs::create_directories(folder / "no-osmesa");
  fs::create_directories(folder / "no-egl");
  writeFile(folder / "no-osmesa/libOSMesa.so.8", "");
  writeFile(folder / "no-egl/libEGL.so.1", "");
  const std::string noOsmesa = "LD_LIBRARY_PATH=no-osmesa \"$BEDMIX\" ",
                    noEgl = "LD_LIBRARY_PATH=no-egl \"$BEDMIX\" ",
                    neither = "LD_LIBRARY_PATH=no-osmesa:no-egl \"$BEDMIX\" ";

  ASSERT_EQ(bedmix({"render", "out", "-o", "auto.png"}).exitCode, 0);
  const Outcome fallback = shell(noOsmesa + "render out -o egl.png");
  EXPECT_EQ(fallback.exitCode, 0) << fallback.err;
  EXPECT_EQ(readFile(folder / "egl.png"), readFile(folder / "auto.png"));
  const Outcome chosen = shell(noEgl + "render out -o osmesa.png --gl osmesa");
  EXPECT_EQ(chosen.exitCode, 0) << chosen.err;
  EXPECT_EQ(readFile(folder / "osmesa.png"), readFile(folder / "auto.png"));

  const Outcome missing = shell(noOsmesa + "sheet out -o x.png --gl osmesa");
  EXPECT_EQ(missing.exitCode, 5);
  EXPECT_TRUE(contains(missing.err, "OSMesa: "));
  const Outcome none = shell(neither + "sheet out -o x.png");
  EXPECT_EQ(none.exitCode, 5);
  EXPECT_TRUE(contains(none.err, "OSMesa: "));
  EXPECT_TRUE(contains(none.err, "EGL: "));
  EXPECT_FALSE(fs::exists(folder / "x.png"));

  const Outcome one = shell(noOsmesa + "doctor");
  EXPECT_EQ(one.exitCode, 0) << one.out;
  EXPECT_TRUE(contains(one.out, "apt install libosmesa6"));
  const Outcome blind = shell(neither + "doctor");
  EXPECT_EQ(blind.exitCode, 5);
  EXPECT_TRUE(contains(blind.out, "apt install libegl1"));
  EXPECT_EQ(bedmix({"render", "out", "-o", "x.png", "--gl", "glx"}).exitCode, 2);
}

TEST_F(Commands, AccuracyShowsWhatItCostsAndGoesOn) {
  const Outcome first = bedmix({"accuracy", "tiny", "-o", "price", "--budget", "3"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  EXPECT_TRUE(contains(first.out, "accuracy=standard"));
  const std::string samples = readFile(folder / "price/accuracy.csv");
  EXPECT_EQ(bedmix({"accuracy", "tiny", "-o", "price"}).exitCode, 2);  // would replace them
  const Outcome more = bedmix({"accuracy", "tiny", "-o", "price", "--budget", "3", "--resume"});
  ASSERT_EQ(more.exitCode, 0) << more.err;
  EXPECT_TRUE(readFile(folder / "price/accuracy.csv").starts_with(samples));
}

TEST_F(Commands, CompletionScriptsKnowEveryOption) {
  const Outcome o = shell(
      "\"$BEDMIX\" completion bash > c.bash && bash -n c.bash && source c.bash && "
      "COMP_WORDS=(bedmix run --th) COMP_CWORD=2 && _bedmix && echo \"${COMPREPLY[*]}\" && "
      "COMP_WORDS=(bedmix re) COMP_CWORD=1 && _bedmix && echo \"${COMPREPLY[*]}\" && "
      "COMP_WORDS=(bedmix check tian-2007-e) COMP_CWORD=2 && _bedmix && echo \"${COMPREPLY[*]}\"");
  EXPECT_EQ(o.exitCode, 0) << o.err;
  EXPECT_EQ(o.out, "--threads\nreplay render report recover\ntian-2007-even\n");
  for (const char* shellName : {"zsh", "fish"}) {
    const Outcome script = bedmix({"completion", shellName});
    EXPECT_EQ(script.exitCode, 0);
    for (const char* word : {"replay", "min-particles", "tian-2007-even"})
      EXPECT_TRUE(contains(script.out, word));
  }
  EXPECT_EQ(bedmix({"completion", "tcsh"}).exitCode, 2);
}

TEST_F(Commands, QuietSaysNothing) {
  const Outcome o = bedmix({"--quiet", "run", "tiny", "-o", "r"});
  EXPECT_EQ(o.exitCode, 0);
  EXPECT_EQ(o.err + o.out, "");
}

}  // namespace
}  // namespace bedmix
