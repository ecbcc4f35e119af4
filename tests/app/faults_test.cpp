// SPDX-License-Identifier: MIT
#include "replay/csv.h"
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class Faults : public ProgramTest {
 protected:
  /// Expects an exit code and a part of what is said about it.
  void expectFault(int exitCode, const std::string& message, const std::vector<std::string>& arguments) {
    const Outcome o = bedmix(arguments);
    EXPECT_EQ(o.exitCode, exitCode) << ::testing::PrintToString(arguments);
    EXPECT_TRUE(contains(o.err, message)) << ::testing::PrintToString(arguments);
  }
  void runTiny() { ASSERT_EQ(bedmix({"run", "tiny", "-o", "r"}).exitCode, 0); }
};

TEST_F(Faults, UsageIsExplained) {
  expectFault(2, "there is no command \"rnu\" (see bedmix --help); did you mean \"run\"?", {"rnu"});
  expectFault(2, "see bedmix --help", {});
  expectFault(2, "scene is required; see bedmix run --help", {"run"});
  expectFault(2, "--thread", {"run", "tiny", "--thread", "2"});
  expectFault(2, "--threads", {"run", "tiny", "--threads", "0"});
  expectFault(2, "must be path=value", {"run", "tiny", "--set", "gas.step"});
  expectFault(2, "--until: time.duration is -1 s", {"run", "tiny", "--until", "-1"});
  expectFault(2, "did you mean \"tiny\"?", {"check", "tinny"});
  expectFault(2, "there is no such scene file", {"check", "no/such.toml"});
}

TEST_F(Faults, EveryMistakeOfASceneIsNamedWithItsPlace) {
  std::string text = readFile(BEDMIX_SOURCE_DIR "/assets/scenes/tiny.toml");
  const auto replace = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  replace("restitution", "resitution");
  replace("density = 1500.0", "density = \"heavy\"");
  replace("thickness = 0.004", "thickness = -1.0");
  replace("[[4, 0.012]]", "[[5, 0.012]]");
  writeFile(folder / "bad.toml", text);
  for (const char* command : {"check", "run"}) {
    const Outcome o = bedmix({command, "bad.toml"});
    EXPECT_EQ(o.exitCode, 2);
    EXPECT_TRUE(contains(o.err, "bad.toml:8:13: bed.thickness is -1 m; it must be above 0 m"));
    EXPECT_TRUE(
        contains(o.err, "bad.toml:13:11: particles.density must be a number, not the text \"heavy\""));
    EXPECT_TRUE(contains(
        o.err, "bad.toml:17:1: unknown key \"resitution\" in [contacts]; did you mean \"restitution\"?"));
    EXPECT_TRUE(contains(o.err, "bad.toml:30:11: the cells add up to 0.06 m, but bed.width is 0.048 m"));
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 4) << o.err;
  }
  EXPECT_FALSE(fs::exists(folder / "out"));

  const Outcome json = bedmix({"check", "bad.toml", "--json"});
  EXPECT_EQ(json.exitCode, 2);
  const auto report = nlohmann::json::parse(json.out);
  EXPECT_EQ(report["valid"], false);
  EXPECT_EQ(report["problems"].size(), 4u);
  EXPECT_EQ(report["problems"][2]["line"], 17);
}

TEST_F(Faults, FolderOfAnotherRunNeedsForce) {
  runTiny();
  writeFile(folder / "r/notes.txt", "mine");
  const std::string before = readFile(folder / "r/mixing.csv");
  expectFault(2, "this folder is not empty", {"run", "tiny", "-o", "r", "--until", "0.02"});
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), before);

  ASSERT_EQ(bedmix({"run", "settling", "-o", "r", "--until", "0.02", "--force"}).exitCode, 0);
  EXPECT_NE(readFile(folder / "r/mixing.csv"), before);
  EXPECT_FALSE(fs::exists(folder / "r/flux.csv")) << "left over from the run before";
  EXPECT_EQ(readFile(folder / "r/notes.txt"), "mine");
}

TEST_F(Faults, FolderThatCannotBeMade) {
  writeFile(folder / "file", "");
  expectFault(4, "is a file", {"run", "tiny", "-o", "file"});
  expectFault(4, "cannot make this folder", {"run", "tiny", "-o", "file/below"});
  expectFault(4, "cannot make this folder", {"run", "tiny", "-o", "/proc/bedmix"});
}

TEST_F(Faults, FullDiskEndsTheRunAndKeepsWhatIsWritten) {
  const auto run = start({"run", "tiny", "--until", "1000", "-o", "r"});
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  run->fillDisk(160 << 10);
  const Outcome o = run->wait();
  EXPECT_EQ(o.exitCode, 4);
  EXPECT_TRUE(contains(o.err, "trajectory.h5"));
  const auto reader = TrajectoryReader::open(folder / "r");
  ASSERT_TRUE(reader) << toString(reader.problems.at(0));
  EXPECT_GT(reader->times().size(), 2u);
  EXPECT_LT(reader->times().back(), 1000.0);
  EXPECT_EQ(bedmix({"replay", "r"}).exitCode, 0);
}

TEST_F(Faults, InvalidSolutionEndsTheRunAndKeepsWhatIsWritten) {
  const Outcome o = bedmix({"run", "tiny", "-o", "r", "--set", "start.arrangement=drop", "--until", "1",
                            "--set", "limits.max_overlap=1e-3", "--set", "limits.warn_overlap=1e-4"});
  EXPECT_EQ(o.exitCode, 3);
  EXPECT_TRUE(contains(o.err, "limits.max_overlap"));
  const auto reader = TrajectoryReader::open(folder / "r");
  ASSERT_TRUE(reader) << toString(reader.problems.at(0));
  EXPECT_TRUE(contains(readFile(folder / "r/summary.json"), "\"end_reason\": \"invalid\""));
}

class FaultsStop : public Faults, public ::testing::WithParamInterface<int> {};

TEST_P(FaultsStop, SignalFlushesAndLeavesAReadableRun) {
  const auto run = start({"run", "tiny", "-o", "r", "--until", "1000"});
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  run->send(GetParam());
  const Outcome o = run->wait();
  EXPECT_EQ(o.exitCode, 130);
  EXPECT_TRUE(contains(o.err, "stopped after"));
  EXPECT_TRUE(contains(readFile(folder / "r/summary.json"), "\"end_reason\": \"stopped\""));

  const auto reader = TrajectoryReader::open(folder / "r");
  ASSERT_TRUE(reader) << toString(reader.problems.at(0));
  const auto table = readCsv(folder / "r/mixing.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows(), reader->times().size());
  ASSERT_EQ(bedmix({"replay", "r"}).exitCode, 0);
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), readFile(folder / "r/replay/mixing.csv"));
}

INSTANTIATE_TEST_SUITE_P(Signals, FaultsStop, ::testing::Values(SIGINT, SIGTERM));

TEST_F(Faults, KilledRunIsReadable) {
  const auto run = start({"run", "tiny", "-o", "r", "--until", "1"});
  ASSERT_TRUE(run->waitForMessage("0.100 s of 1 s"));
  run->send(SIGKILL);
  EXPECT_EQ(run->wait().exitCode, 128 + SIGKILL);
  const auto reader = TrajectoryReader::open(folder / "r");
  ASSERT_TRUE(reader) << toString(reader.problems.at(0));
  EXPECT_GE(reader->times().back(), 0.1);
  EXPECT_EQ(bedmix({"replay", "r"}).exitCode, 0);
}

TEST_F(Faults, ReaderOfStdoutThatLeavesIsNoTrouble) {
  EXPECT_EQ(shell("\"$BEDMIX\" check tiny --resolved | true; exit ${PIPESTATUS[0]}").exitCode, 0);
}

TEST_F(Faults, TrajectoryThatIsMissingOrForeign) {
  expectFault(4, "trajectory.h5", {"replay", "nowhere"});
  writeFile(folder / "trajectory.h5", "not HDF5");
  for (const char* command : {"replay", "render", "sheet"}) {
    const Outcome o = bedmix({command, "trajectory.h5", "-o", "x.png"});
    EXPECT_EQ(o.exitCode, 4) << command;
    EXPECT_TRUE(contains(o.err, "trajectory.h5")) << command;
  }
  expectFault(4, "has no mixing.csv", {"plot", ".", "-o", "x.png"});
}

TEST_F(Faults, ReplayOptions) {
  runTiny();
  expectFault(2, "is not columns x rows", {"replay", "r", "--sampling", "4"});
  expectFault(2, "--sampling: sampling.columns is 0", {"replay", "r", "--sampling", "0x4"});
  expectFault(2, "did you mean \"left-half\"?", {"replay", "r", "--tracer", "lefthalf"});
  expectFault(2, "no frame lies between 3 and 4 s; the run goes from 0 to 0.05 s",
              {"replay", "r", "--from", "3", "--to", "4"});
  expectFault(2, "this folder holds a run", {"replay", "r", "-o", "r"});
}

TEST_F(Faults, PictureOptions) {
  runTiny();
  expectFault(2, "--layers: pictures.layers.0 has no \"particels\"; did you mean \"particles\"?",
              {"render", "r", "-o", "x.png", "--layers", "particels"});
  expectFault(2, "--layers: pictures.layers.1 has no \"\"",
              {"render", "r", "-o", "x.png", "--layers", "walls,"});
  expectFault(2, "--color: pictures.color has no \"sped\"; did you mean \"speed\"?",
              {"render", "r", "-o", "x.png", "--color", "sped"});
  expectFault(2, "--color: pictures.classes must be a whole number",
              {"render", "r", "-o", "x.png", "--color", "strips:"});
  expectFault(2, "--color: pictures.classes is 0", {"render", "r", "-o", "x.png", "--color", "strips:0"});
  expectFault(2, "--background: pictures.background must be",
              {"render", "r", "-o", "x.png", "--background", "blue"});
  expectFault(2, "--trails: there is no particle 60", {"render", "r", "-o", "x.png", "--trails", "3,60"});
  expectFault(2, "--picture trail_tme=1: unknown key \"trail_tme\" in [pictures]; did you mean",
              {"render", "r", "-o", "x.png", "--picture", "trail_tme=1"});
  expectFault(2, "'counts' has no room in sampling cells",
              {"render", "r", "-o", "x.png", "--layers", "counts", "--size", "40x60"});
  expectFault(2, "--size", {"render", "r", "-o", "x.png", "--size", "99999x100"});
  expectFault(2, "--size", {"render", "r", "-o", "x.mp4", "--size", "large"});
  expectFault(2, "--time", {"render", "r", "-o", "x.png", "--time", "3"});
  expectFault(2, "--times", {"sheet", "r", "-o", "x.png", "--times", "0,7"});
  expectFault(2, "goes with one picture", {"render", "r", "-o", "x.mp4", "--time", "0"});
  expectFault(2, "is no kind of picture", {"render", "r", "-o", "x.bmp"});
  expectFault(2, "a sheet is a .png picture", {"sheet", "r", "-o", "x.svg"});
  expectFault(2, "--kind", {"plot", "r", "-o", "x.png", "--kind", "mixxing"});
  expectFault(4, "below/x.png", {"render", "r", "-o", "r/mixing.csv/below/x.png"});
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_FALSE(entry.path().filename().string().starts_with("x.")) << entry.path();
}

TEST_F(Faults, GasLayerOfARunWithoutGas) {
  ASSERT_EQ(bedmix({"run", "settling", "-o", "s", "--until", "0.01"}).exitCode, 0);
  expectFault(2, "gas", {"render", "s", "-o", "x.png", "--layers", "particles,voidage"});
  expectFault(2, "--color: the colour 'voidage' needs the gas",
              {"render", "s", "-o", "x.png", "--color", "voidage"});
  expectFault(4, "has no pressure.csv", {"plot", "s", "-o", "x.png", "--kind", "pressure"});
}

TEST_F(Faults, PlotWithoutGnuplotIsUnavailable) {
  runTiny();
  const Outcome o = shell("PATH=/nowhere \"$BEDMIX\" plot r -o x.png");
  EXPECT_EQ(o.exitCode, 5);
  EXPECT_TRUE(contains(o.err, "gnuplot"));
}

}  // namespace
}  // namespace bedmix
