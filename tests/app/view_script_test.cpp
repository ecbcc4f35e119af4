// SPDX-License-Identifier: MIT
#include "render/png.h"
#include "tests/app/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

/// `bedmix view` by scripts, which need neither a browser nor the clock.
class ViewScriptPipeline : public ProgramTest {
 protected:
  Outcome play(const std::string& what, const std::string& script, const std::string& frames) {
    writeFile(folder / "script.toml", script);
    return bedmix({"view", what, "--script", "script.toml", "--frames", frames, "-o", "saved"});
  }
  Image picture(const std::string& frames, int number) const {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06d.png", number);
    return readPng(folder / frames / name).value.value_or(Image{});
  }
  std::size_t count(const std::string& frames) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder / frames), fs::directory_iterator{}));
  }
};

/// Differing pixels of the part of two pictures left of `right`.
std::size_t differing(const Image& a, const Image& b, int right) {
  std::size_t count = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < right; ++x) count += a.at(x, y) == b.at(x, y) ? 0 : 1;
  return count;
}

constexpr const char* opening = "size = [800, 480]\nfps = 20\n";
constexpr int bedWidth = 800 - 330;

TEST_F(ViewScriptPipeline, SameScriptGivesTheSamePictures) {
  const std::string script = std::string(opening) +
                             "until = 0.5\n"
                             "[[do]]\nat = 0.1\ndrag = \"velocity 1\"\nto = 0.9\n"
                             "[[do]]\nat = 0.2\nclick = \"velocity\"\n";
  ASSERT_EQ(play("tiny", script, "a").exitCode, 0);
  ASSERT_EQ(play("tiny", script, "b").exitCode, 0);
  ASSERT_EQ(count("a"), count("b"));
  ASSERT_GE(count("a"), 11u);
  for (int i = 0; i < static_cast<int>(count("a")); ++i)
    EXPECT_EQ(picture("a", i).rgba, picture("b", i).rgba) << i;
  EXPECT_GT(differing(picture("a", 1), picture("a", 8), bedWidth), 100u) << "the bed moves";
}

TEST_F(ViewScriptPipeline, PauseStopsTheBed) {
  ASSERT_EQ(
      play("tiny", std::string(opening) + "until = 0.6\n[[do]]\nat = 0.1\nclick = \"play\"\n", "a").exitCode,
      0);
  EXPECT_GT(differing(picture("a", 1), picture("a", 3), bedWidth), 0u);
  EXPECT_EQ(differing(picture("a", 7), picture("a", 11), bedWidth), 0u);
}

TEST_F(ViewScriptPipeline, MoreGasMakesAHigherBed) {
  const auto height = [](const Image& image) {
    // Rows that have something green or black on them, of the middle of the bed.
    int top = image.size.height;
    for (int y = 0; y < image.size.height; ++y)
      for (int x = 0; x < bedWidth && top == image.size.height; ++x) {
        const Rgba c = image.at(x, y);
        if (c.r == 0 && c.g == 158 && c.b == 115) top = y;
      }
    return image.size.height - top;
  };
  const std::string layers = "size = [800, 480]\nfps = 20\nuntil = 1.5\n[[do]]\nat = 0\nclick = \"hud\"\n";
  ASSERT_EQ(play("tiny", layers + "[[do]]\nat = 0.1\ndrag = \"velocity 1\"\nto = 0.0\n", "low").exitCode, 0);
  ASSERT_EQ(play("tiny", layers + "[[do]]\nat = 0.1\ndrag = \"velocity 1\"\nto = 0.7\n", "high").exitCode, 0);
  EXPECT_GT(height(picture("high", 30)), height(picture("low", 30)) + 20);
}

TEST_F(ViewScriptPipeline, RecordingAndSceneTellWhatWasChanged) {
  const Outcome done = play("tiny",
                            std::string(opening) +
                                "until = 1.6\n"
                                "[[do]]\nat = 0.1\nclick = \"Save\"\n"
                                "[[do]]\nat = 0.2\nclick = \"Record\"\n"
                                "[[do]]\nat = 0.6\ndrag = \"velocity 1\"\nto = 0.5\n"
                                "[[do]]\nat = 1.2\nclick = \"Stop recording\"\n"
                                "[[do]]\nat = 1.3\nclick = \"Save scene\"\n"
                                "[[do]]\nat = 1.4\nclick = \"Save picture\"\n",
                            "a");
  ASSERT_EQ(done.exitCode, 0) << done.err;
  ASSERT_TRUE(fs::exists(folder / "saved/recording-1/trajectory.h5")) << done.err;
  const Outcome replayed = bedmix({"replay", "saved/recording-1", "-o", "replayed"});
  EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
  EXPECT_EQ(readFile(folder / "replayed/mixing.csv"), readFile(folder / "saved/recording-1/mixing.csv"));
  const Outcome events = shell(
      "/usr/bin/python3 -c \"import h5py; f = h5py.File('saved/recording-1/trajectory.h5'); "
      "print(f['bedmix/events/kind'][0], f['bedmix/events/detail'][:])\"");
  EXPECT_TRUE(contains(events.out, "set")) << events.err;
  EXPECT_TRUE(contains(events.out, "gas.inlets.0.velocity = "));
  EXPECT_TRUE(contains(readFile(folder / "saved/scene-1.toml"), "velocity = "));
  EXPECT_EQ(bedmix({"check", "saved/scene-1.toml"}).exitCode, 0);
  EXPECT_TRUE(readPng(folder / "saved/picture-1.png"));
}

TEST_F(ViewScriptPipeline, RecordedRunIsSoughtAndResampled) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "run"}).exitCode, 0);
  const Outcome done = play("run",
                            std::string(opening) +
                                "until = 1.2\n"
                                "[[do]]\nat = 0.1\nkey = \"End\"\n"
                                "[[do]]\nat = 0.3\nkey = \"Home\"\n"
                                "[[do]]\nat = 0.5\nclick = \"sampling\"\n"
                                "[[do]]\nat = 0.7\nclick = \"Sampling cells\"\n"
                                "[[do]]\nat = 0.9\ndrag = \"columns\"\nto = 0.5\n",
                            "a");
  ASSERT_EQ(done.exitCode, 0) << done.err;
  EXPECT_GT(differing(picture("a", 1), picture("a", 4), bedWidth), 100u) << "the end is not the start";
  EXPECT_EQ(differing(picture("a", 1), picture("a", 8), bedWidth), 0u) << "home again";
  EXPECT_GT(differing(picture("a", 13), picture("a", 24), bedWidth), 100u) << "more cells";
}

TEST_F(ViewScriptPipeline, TwoRunsAreShownSideBySideTheSameEachTime) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "one"}).exitCode, 0);
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "two", "--seed", "2"}).exitCode, 0);
  writeFile(folder / "script.toml", std::string(opening) + "until = 0.2\n[[do]]\nat = 0.05\nkey = \"End\"\n");
  for (const char* frames : {"a", "b"}) {
    const Outcome done = bedmix({"view", "one", "two", "--script", "script.toml", "--frames", frames});
    EXPECT_EQ(done.exitCode, 0) << done.err;
  }
  EXPECT_EQ(count("a"), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(picture("a", i).rgba, picture("b", i).rgba) << i;
}

constexpr const char* startRecording =
    "[[do]]\nat = 0.1\nclick = \"Save\"\n"
    "[[do]]\nat = 0.2\nclick = \"Record\"\n";

TEST_F(ViewScriptPipeline, SteeredRunThatBecomesInvalidLosesNothingAndCanBeginAgain) {
  const auto soften = [](const char* stiffness) {
    return std::string("[[do]]\nat = 0.3\nclick = \"contacts.stiffness\"\n[[do]]\nat = 0.4\ntype = \"") +
           stiffness + "\"\n[[do]]\nat = 0.5\nkey = \"Enter\"\n";
  };
  const std::string open = std::string(opening) + "until = 6.0\n" + startRecording +
                           "[[do]]\nat = 0.2\nclick = \"All parameters\"\n"
                           "[[do]]\nat = 0.2\nclick = \"contacts\"\n";
  const Outcome done = play("tiny",
                            open + soften("0.5") + "[[do]]\nat = 4.0\nclick = \"contacts.stiffness\"\n" +
                                "[[do]]\nat = 4.1\ntype = \"2000\"\n[[do]]\nat = 4.2\nkey = \"Enter\"\n"
                                "[[do]]\nat = 5.0\nclick = \"Restart\"\n[[do]]\nat = 5.2\nclick = \"play\"\n",
                            "a");
  ASSERT_EQ(done.exitCode, 0) << done.err;
  const int last = static_cast<int>(count("a")) - 1;
  EXPECT_EQ(differing(picture("a", 74), picture("a", 78), bedWidth), 0u) << "it stands still";
  EXPECT_GT(differing(picture("a", last - 4), picture("a", last), bedWidth), 0u) << "it runs again";
  const Outcome replayed = bedmix({"replay", "saved/recording-1", "-o", "replayed"});
  EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
  EXPECT_TRUE(fs::exists(folder / "saved/recording-2/trajectory.h5")) << "from the restart on";
}

TEST_F(ViewScriptPipeline, SignalEndsTheViewAndTheRecordingIsWhole) {
  writeFile(folder / "script.toml", std::string(opening) + "until = 1e5\n" + startRecording);
  const auto view = this->start({"view", "tiny", "--script", "script.toml", "--frames", "a", "-o", "saved"});
  while (!fs::exists(folder / "a/frame_000040.png"))
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  view->send(SIGTERM);
  EXPECT_EQ(view->wait().exitCode, 130);
  const Outcome replayed = bedmix({"replay", "saved/recording-1", "-o", "replayed"});
  EXPECT_EQ(replayed.exitCode, 0) << replayed.err;
  EXPECT_EQ(readFile(folder / "replayed/mixing.csv"), readFile(folder / "saved/recording-1/mixing.csv"));
}

TEST_F(ViewScriptPipeline, WrongScriptsAreToldByLine) {
  const Outcome none = play("tiny", "until = 1\n[[do]]\nat = 0.1\nclick = \"Plya\"\n", "a");
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_TRUE(contains(none.err, "script.toml:2:1: the panel has no \"Plya\""));
  const Outcome wrong =
      play("tiny", "until = \"long\"\nsize = [8, 8]\n[[do]]\nat = 0\nkey = \"F13\"\nhold = 1\n", "a");
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_TRUE(contains(wrong.err, "script.toml:1:9: until must be a number"));
  EXPECT_TRUE(contains(wrong.err, "script.toml:2:8: "));
  EXPECT_TRUE(contains(wrong.err, "there is no key \"hold\" here"));
  EXPECT_TRUE(contains(wrong.err, "there is no key \"F13\""));
  EXPECT_EQ(bedmix({"view", "tiny", "--script", "script.toml"}).exitCode, 2);
  EXPECT_EQ(bedmix({"view", "no-such-thing"}).exitCode, 2);
}

}  // namespace
}  // namespace bedmix
