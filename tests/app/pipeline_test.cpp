// SPDX-License-Identifier: MIT
#include "render/png.h"
#include "replay/csv.h"
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

nlohmann::json summaryOf(const fs::path& run) {
  return nlohmann::json::parse(readFile(run / "summary.json"));
}

std::string headerOf(const fs::path& csv) {
  const std::string text = readFile(csv);
  return text.substr(0, text.find('\n'));
}

class Pipeline : public ProgramTest {};

TEST_F(Pipeline, RunLeavesEveryFileOfARunFolder) {
  const Outcome run = bedmix({"run", "tiny", "-o", "tiny", "--video"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const fs::path tiny = folder / "tiny";
  EXPECT_EQ(headerOf(tiny / "mixing.csv"),
            "time,lacey,ashton,stddev,tracer_mean,cells,particles_per_cell,counted_fraction");
  EXPECT_EQ(headerOf(tiny / "flux.csv"), "time,flux");
  EXPECT_EQ(headerOf(tiny / "pressure.csv"), "time,pressure_drop,bed_height");
  EXPECT_GT(fs::file_size(tiny / "video.mp4"), 1000u);

  const auto reader = TrajectoryReader::open(tiny);
  ASSERT_TRUE(reader) << toString(reader.problems.at(0));
  EXPECT_EQ(reader->times(), (std::vector<double>{0.0, 0.01, 0.02, 0.03, 0.04, 0.05}));
  EXPECT_EQ(reader->scene().particles.count, 60);

  const auto summary = summaryOf(tiny);
  EXPECT_EQ(summary["scene"], "tiny");
  EXPECT_EQ(summary["seed"], 1);
  EXPECT_EQ(summary["steps"], 5000);
  EXPECT_EQ(summary["gas_steps"], 500);
  EXPECT_EQ(summary["simulated_seconds"], 0.05);
  EXPECT_EQ(summary["end_reason"], "finished");
  EXPECT_EQ(summary["state_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(summary["settings"]["gas"]["drag"], "ergun-wen-yu");
  EXPECT_EQ(summary["stages"].size(), 7u);
}

TEST_F(Pipeline, SceneWithoutGasOrWindowLeavesNoFilesOfThem) {
  ASSERT_EQ(bedmix({"run", "settling", "-o", "s", "--until", "0.02"}).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder / "s/mixing.csv"));
  EXPECT_FALSE(fs::exists(folder / "s/pressure.csv"));
  EXPECT_FALSE(fs::exists(folder / "s/flux.csv"));
  EXPECT_EQ(summaryOf(folder / "s")["gas_steps"], 0);
}

TEST_F(Pipeline, OptionsChangeTheScene) {
  const Outcome run =
      bedmix({"run", "tiny", "-o", "r", "--until", "0.02", "--seed", "7", "--set",
              "contacts.restitution=", "--set", "contacts.damping=0.17", "--json", "--quiet"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(nlohmann::json::parse(run.out), summaryOf(folder / "r"));
  const auto settings = summaryOf(folder / "r")["settings"];
  EXPECT_EQ(settings["seed"], 7);
  EXPECT_EQ(settings["time"]["duration"], 0.02);
  EXPECT_EQ(settings["contacts"]["damping"], 0.17);
  EXPECT_FALSE(settings["contacts"].contains("restitution"));
}

TEST_F(Pipeline, ThreadsDoNotChangeTheState) {
  for (const char* threads : {"1", "2", "3"})
    ASSERT_EQ(bedmix({"run", "tiny", "-o", threads, "--threads", threads}).exitCode, 0);
  const auto hash = summaryOf(folder / "1")["state_hash"];
  EXPECT_EQ(summaryOf(folder / "2")["state_hash"], hash);
  EXPECT_EQ(summaryOf(folder / "3")["state_hash"], hash);
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "other", "--seed", "2"}).exitCode, 0);
  EXPECT_NE(summaryOf(folder / "other")["state_hash"], hash);
}

TEST_F(Pipeline, ReplayWithOtherSettings) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r"}).exitCode, 0);
  const Outcome replay =
      bedmix({"replay", "r/trajectory.h5", "-o", "other", "--sampling", "4x12", "--min-particles", "2",
              "--tracer", "lower-half", "--from", "0.01", "--to", "0.04", "--every", "2", "--json"});
  ASSERT_EQ(replay.exitCode, 0) << replay.err;
  EXPECT_EQ(nlohmann::json::parse(replay.out)["frames"], 2);
  const auto table = readCsv(folder / "other/mixing.csv");
  ASSERT_TRUE(table) << toString(table.problems.at(0));
  ASSERT_EQ(table->rows(), 2u);
  EXPECT_EQ(table->find("time")->at(0), 0.01);
  EXPECT_EQ(table->find("time")->at(1), 0.03);
  EXPECT_GT(table->find("cells")->at(0), 4.0);          // of 4 x 12 small ones; the scene's own has 2 x 6
  EXPECT_LT(table->find("lacey")->at(0).value(), 0.5);  // bottom and top are not mixed yet
}

TEST_F(Pipeline, VectorInstructionsDoNotChangeTheState) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "auto"}).exitCode, 0);
  const auto best = summaryOf(folder / "auto");
  const std::string here = bedmix({"doctor"}).out;
  EXPECT_TRUE(contains(here, best["simd"].get<std::string>() + ", of baseline"));
  for (const char* level : {"baseline", "avx2", "avx512"}) {
    const Outcome run = bedmix({"run", "tiny", "-o", level, "--simd", level});
    if (here.find(level) != std::string::npos) {
      ASSERT_EQ(run.exitCode, 0) << run.err;
      EXPECT_EQ(summaryOf(folder / level)["simd"], level);
      EXPECT_EQ(summaryOf(folder / level)["state_hash"], best["state_hash"]);
    } else {
      EXPECT_EQ(run.exitCode, 2);
      EXPECT_TRUE(contains(run.err, "this machine lacks it; it has baseline"));
      EXPECT_FALSE(fs::exists(folder / level));
    }
  }
}

TEST_F(Pipeline, SmallBedsRunOnOneThreadUnlessToldOtherwise) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "auto", "--threads", "auto"}).exitCode, 0);
  EXPECT_EQ(summaryOf(folder / "auto")["threads"], 1);
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "two", "--threads", "2"}).exitCode, 0);
  EXPECT_EQ(summaryOf(folder / "two")["threads"], 2);
}

struct Case {
  const char* scene;
  const char* until;
};
class PipelineOf : public ProgramTest, public ::testing::WithParamInterface<Case> {};

TEST_P(PipelineOf, ReplayedSeriesAreTheBytesOfTheRun) {
  const Outcome run = bedmix({"run", GetParam().scene, "-o", "r", "--until", GetParam().until});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Outcome replay = bedmix({"replay", "r"});
  ASSERT_EQ(replay.exitCode, 0) << replay.err;
  for (const char* name : {"mixing.csv", "flux.csv", "pressure.csv"}) {
    const std::string live = readFile(folder / "r" / name);
    EXPECT_GT(live.size(), 100u) << name;
    EXPECT_EQ(live, readFile(folder / "r/replay" / name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PipelineOf,
                         ::testing::Values(Case{"tiny", "0.05"}, Case{"tian-2007-even", "0.3"},
                                           Case{"tian-2007-inclined", "0.3"}),
                         [](const auto& c) {
                           std::string name = c.param.scene;
                           std::erase(name, '-');
                           return name;
                         });

TEST_F(Pipeline, PicturesOfARecordedRun) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r"}).exitCode, 0);
  const auto expectDone = [&](std::vector<std::string> arguments) {
    const Outcome o = bedmix(std::move(arguments));
    EXPECT_EQ(o.exitCode, 0) << o.err;
  };
  expectDone({"render", "r", "-o", "one.png", "--time", "0.03", "--layers",
              "particles,velocity,sampling,gas,voidage,walls,hud", "--size", "401x641"});
  const auto image = readPng(folder / "one.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->size, (Size{401, 641}));

  expectDone({"render", "r", "-o", "frames", "--every", "2"});
  EXPECT_TRUE(fs::exists(folder / "frames/frame_000002.png"));
  EXPECT_FALSE(fs::exists(folder / "frames/frame_000003.png"));

  expectDone({"render", "r", "-o", "film.mp4", "--fps", "25", "--speed", "0.1"});
  EXPECT_GT(fs::file_size(folder / "film.mp4"), 1000u);
  EXPECT_FALSE(fs::exists(folder / "film.mp4.part"));

  expectDone({"sheet", "r", "-o", "sheet.png", "--times", "0,0.02,0.05"});
  EXPECT_TRUE(readPng(folder / "sheet.png"));
  for (const char* kind : {"mixing", "compare", "flux", "pressure"})
    expectDone({"plot", "r", "-o", std::string(kind) + ".svg", "--kind", kind});
  EXPECT_TRUE(contains(readFile(folder / "mixing.svg"), "<svg"));
  expectDone({"replay", "r"});
  expectDone({"plot", "r", "r/replay", "-o", "two.png"});
  EXPECT_TRUE(readPng(folder / "two.png"));
}

TEST_F(Pipeline, InstalledProgramFindsItsScenes) {
  const Outcome install = shell("'" BEDMIX_CMAKE "' --install '" BEDMIX_BUILD_DIR
                                "' --prefix usr >/dev/null && mv usr moved && "
                                "cd / && \"$OLDPWD/moved/bin/bedmix\" run tiny -q -o \"$OLDPWD/r\" && "
                                "\"$OLDPWD/moved/bin/bedmix\" doctor");
  ASSERT_EQ(install.exitCode, 0) << install.err << install.out;
  EXPECT_TRUE(contains(install.out, "moved/share/bedmix/scenes"));
  EXPECT_TRUE(fs::exists(folder / "r/mixing.csv"));
}

}  // namespace
}  // namespace bedmix
