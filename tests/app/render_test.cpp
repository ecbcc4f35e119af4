// SPDX-License-Identifier: MIT
#include "render/png.h"
#include "tests/app/program.h"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <map>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

using Files = std::map<std::string, std::string>;

Files filesIn(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = readFile(entry.path());
  return files;
}

/// A run of 51 frames, 0 to 0.5 s.
class Rendering : public ProgramTest {
 protected:
  Rendering() {
    if (bedmix({"run", "tiny", "-o", "r", "--until", "0.5"}).exitCode != 0) std::abort();
  }
  Outcome frames(const std::string& into, std::vector<std::string> more = {},
                 const std::string& size = "160x240") {
    std::vector<std::string> arguments{"render", "r", "-o", into, "--size", size};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bedmix(arguments);
  }
  void expectRefused(const std::string& why, const std::vector<std::string>& more,
                     const std::string& size = "160x240") {
    const Files before = filesIn(folder / "f");
    const Outcome o = frames("f", more, size);
    EXPECT_EQ(o.exitCode, 2) << why;
    EXPECT_TRUE(contains(o.err, why));
    EXPECT_TRUE(contains(o.err, "--force"));
    EXPECT_TRUE(filesIn(folder / "f") == before);
  }
};

using RenderingPipeline = Rendering;
using RenderingFaults = Rendering;

TEST_F(RenderingPipeline, FilmsOfEachKind) {
  for (const char* ending : {"mp4", "gif", "mkv"}) {
    const std::string file = std::string("x.") + ending;
    const Outcome o = frames(file, {"--fps", "50", "--speed", "0.5", "--from", "0.1", "--to", "0.4"});
    ASSERT_EQ(o.exitCode, 0) << o.err;
    EXPECT_TRUE(contains(o.err, file + ": 31 pictures at 50 a second"));
    EXPECT_TRUE(contains(o.err, "31 of 31 pictures"));
  }
  EXPECT_TRUE(contains(frames("x.mp4", {}, "65x97").err, "the film has 66x98 pixels"));
  const Outcome gif = frames("x.gif", {"--fps", "30"});
  EXPECT_TRUE(contains(gif.err, "33.33 pictures a second, not 30"));
  EXPECT_TRUE(contains(gif.err, "17 pictures"));  // 0.5 s of them, and the one at 0
}

TEST_F(RenderingPipeline, RunsSideBySide) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "s", "--until", "0.3", "--set", "sampling.interval=0.02"}).exitCode,
            0);
  const std::vector<std::string> together{"--layers", "particles,hud,curve", "--size", "640x360"};
  const auto render = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), together.begin(), together.end());
    return bedmix(arguments);
  };
  Outcome o = render({"r", "s", "-o", "both.mp4", "--fps", "50"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_TRUE(contains(o.err, "both.mp4: 26 pictures"));  // as long as the longer one

  // A frame of a folder is the picture of its time, curves of what was before included.
  o = render({"r", "s", "-o", "f", "--from", "0.2", "--to", "0.25"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_EQ(filesIn(folder / "f").size(), 6u);
  o = render({"r", "s", "-o", "one.png", "--time", "0.23"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  const auto fromFolder = readPng(folder / "f" / "frame_000003.png"), alone = readPng(folder / "one.png");
  ASSERT_TRUE(fromFolder && alone);
  EXPECT_EQ(alone->size, (Size{640, 360}));
  EXPECT_TRUE(fromFolder->rgba == alone->rgba);

  o = render({"r", "s", "-o", "late.png", "--time", "0.4"});
  EXPECT_EQ(o.exitCode, 2);
  EXPECT_TRUE(contains(o.err, "there is no frame at t = 0.4 s"));
}

TEST_F(RenderingPipeline, FolderIsFilledAndThenKept) {
  const Outcome first = frames("f", {"--from", "0.1", "--to", "0.3", "--every", "5"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const Files files = filesIn(folder / "f");
  ASSERT_EQ(files.size(), 5u);
  EXPECT_EQ(files.begin()->first, "frame_000000.png");
  EXPECT_EQ(files.rbegin()->first, "frame_000004.png");
  EXPECT_TRUE(contains(files.rbegin()->second, "step 30000, 0.3 s"));
  EXPECT_EQ(readPng(folder / "f/frame_000004.png")->size, (Size{160, 240}));

  const Outcome again = frames("f", {"--from", "0.1", "--to", "0.3", "--every", "5"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_TRUE(contains(again.err, "5 of them were there"));
  EXPECT_TRUE(filesIn(folder / "f") == files);
}

TEST_F(RenderingPipeline, FolderLacksWhatIsGoneOn) {
  ASSERT_EQ(frames("whole").exitCode, 0);
  ASSERT_EQ(frames("f").exitCode, 0);
  const Files whole = filesIn(folder / "whole");
  ASSERT_EQ(whole.size(), 51u);
  fs::remove(folder / "f/frame_000000.png");
  fs::remove(folder / "f/frame_000010.png");
  fs::resize_file(folder / "f/frame_000020.png", 1000);         // of a machine that went down
  writeFile(folder / "f/frame_000030.png.part", "unfinished");  // of a killed program
  fs::remove(folder / "f/frame_000030.png");
  writeFile(folder / "f/notes.txt", "mine");
  const Outcome o = frames("f");
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_TRUE(contains(o.err, "47 of them were there"));
  EXPECT_EQ(readFile(folder / "f/notes.txt"), "mine");
  fs::remove(folder / "f/notes.txt");
  EXPECT_TRUE(filesIn(folder / "f") == whole);
}

TEST_F(RenderingPipeline, FolderOfAKilledRenderingIsGoneOnWith) {
  const std::vector<std::string> layers{"--layers", "particles,hud,curve"};  // the curve has a past
  ASSERT_EQ(frames("whole", layers).exitCode, 0);
  const auto killed = start({"render", "r", "-o", "f", "--size", "160x240", layers[0], layers[1]});
  ASSERT_TRUE(killed->waitForMessage(" of 51 pictures, "));
  killed->send(SIGKILL);
  killed->wait();
  const Outcome o = frames("f", layers);
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_TRUE(filesIn(folder / "f") == filesIn(folder / "whole"));
}

TEST_F(RenderingFaults, FolderOfAnotherRenderingIsRefused) {
  ASSERT_EQ(frames("f", {"--every", "10"}).exitCode, 0);
  expectRefused("has 160x240 pixels, this one 64x64", {"--every", "10"}, "64x64");
  expectRefused("Description is \"step 10000, 0.1 s\"", {"--every", "5"});
  expectRefused("this one ends with number 2", {"--every", "20"});
  expectRefused("frame_000000.png: belongs to another rendering: it looks different",
                {"--every", "10", "--layers", "particles"});
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r", "--until", "0.5", "--seed", "2", "--force"}).exitCode, 0);
  expectRefused("Source is \"scene tiny, seed 1\", here \"scene tiny, seed 2\"", {"--every", "10"});

  writeFile(folder / "f/notes.txt", "mine");
  ASSERT_EQ(frames("f", {"--every", "20", "--force"}).exitCode, 0);
  EXPECT_EQ(filesIn(folder / "f").size(), 4u);
  EXPECT_EQ(readFile(folder / "f/notes.txt"), "mine");
}

TEST_F(RenderingFaults, FolderIsFilledByOneAtATime) {
  fs::create_directory(folder / "f");
  const int held = open((folder / "f").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(held, LOCK_EX), 0);  // as another program would
  const Outcome second = frames("f");
  EXPECT_EQ(second.exitCode, 4);
  EXPECT_TRUE(contains(second.err, "another bedmix is writing into this folder"));
  close(held);
  EXPECT_EQ(frames("f").exitCode, 0);
}

TEST_F(RenderingFaults, OptionsOfAnotherOutput) {
  const auto expectFault = [&](const std::string& message, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", "r", "-o"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome o = bedmix(arguments);
    EXPECT_EQ(o.exitCode, 2) << message;
    EXPECT_TRUE(contains(o.err, message));
  };
  expectFault("go with a film; a folder has each frame once", {"f", "--fps", "25"});
  expectFault("go with a film", {"x.png", "--speed", "2"});
  expectFault("one picture takes --time", {"x.png", "--from", "0.1"});
  expectFault("goes with one picture", {"x.gif", "--time", "0.1"});
  expectFault("--force: goes with a folder", {"x.mp4", "--force"});
  expectFault("is no kind of picture", {"x.avi"});
  expectFault("--fps", {"x.mp4", "--fps", "1000"});
  expectFault("--speed", {"x.mp4", "--speed", "0"});
  expectFault("no frame lies between 0.6 and", {"x.gif", "--from", "0.6"});
  EXPECT_FALSE(fs::exists(folder / "f"));
}

TEST_F(RenderingFaults, FullDiskUnderAFolderKeepsWhatIsComplete) {
  ASSERT_EQ(frames("whole").exitCode, 0);
  std::uintmax_t largest = 0, smallest = ~0ull;
  for (const auto& [name, bytes] : filesIn(folder / "whole")) {
    largest = std::max<std::uintmax_t>(largest, bytes.size());
    smallest = std::min<std::uintmax_t>(smallest, bytes.size());
  }
  ASSERT_LT(smallest, largest);
  // No file may be as large as the largest.
  const Outcome o = shell("ulimit -f " + std::to_string((largest - 1) / 1024) +
                          "; \"$BEDMIX\" render r -o f --size 160x240");
  EXPECT_EQ(o.exitCode, 4) << o.err;
  EXPECT_TRUE(contains(o.err, "cannot write it: File too large"));
  const Files whole = filesIn(folder / "whole");
  for (const auto& [name, bytes] : filesIn(folder / "f")) EXPECT_TRUE(bytes == whole.at(name)) << name;
  ASSERT_EQ(frames("f").exitCode, 0);
  EXPECT_TRUE(filesIn(folder / "f") == whole);
}

TEST_F(RenderingFaults, FullDiskUnderAFilmLeavesTheOlderOne) {
  for (const char* file : {"x.mp4", "x.gif", "x.mkv"}) {
    writeFile(folder / file, "older");
    const Outcome o = shell(std::string("ulimit -f 8; \"$BEDMIX\" render r -o ") + file + " --size 160x240");
    EXPECT_EQ(o.exitCode, 4) << o.err;
    EXPECT_TRUE(contains(o.err, std::string(file) + ": cannot write it"));
    EXPECT_TRUE(readFile(folder / file) == "older") << file;
    EXPECT_FALSE(fs::exists(folder / (std::string(file) + ".part")));
  }
}

TEST_F(RenderingFaults, WhereNothingMayBeWritten) {
  writeFile(folder / "file", "");
  for (const char* output : {"/proc/x.mp4", "/proc/x.gif", "/proc/x.mkv", "/proc/x.png", "/proc/frames",
                             "file", "file/frames", "none/x.mp4"}) {
    const Outcome o = frames(output);
    EXPECT_EQ(o.exitCode, 4) << output;
    EXPECT_TRUE(contains(o.err, output));
  }
}

TEST_F(RenderingFaults, WithoutAnEncoderFilmsAreUnavailable) {
  for (const char* file : {"x.mp4", "x.gif", "x.mkv"}) {
    // AddressSanitizer, where it is in, wants to be the first library.
    const Outcome o = shell(std::string("ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=") +
                            BEDMIX_NO_ENCODERS + " \"$BEDMIX\" render r -o " + file + " --size 160x240");
    EXPECT_EQ(o.exitCode, 5) << o.err;
    EXPECT_TRUE(contains(o.err, "libavcodec has no"));
    EXPECT_FALSE(fs::exists(folder / file));
  }
}

class RenderingFaultsStop : public Rendering, public ::testing::WithParamInterface<int> {};

TEST_P(RenderingFaultsStop, SignalLeavesNoHalfFilm) {
  for (const char* file : {"x.mp4", "x.gif", "x.mkv"}) {
    const auto film = start({"render", "r", "-o", file, "--size", "160x240", "--speed", "1e-3"});
    ASSERT_TRUE(film->waitForMessage(" of 25001 pictures"));
    film->send(GetParam());
    const Outcome o = film->wait();
    EXPECT_EQ(o.exitCode, 130);
    EXPECT_TRUE(contains(o.err, std::string("of 25001 pictures; ") + file + " is not kept"));
    EXPECT_FALSE(fs::exists(folder / file));
    EXPECT_FALSE(fs::exists(folder / (std::string(file) + ".part")));
  }
}

TEST_P(RenderingFaultsStop, SignalLeavesAFolderToGoOnWith) {
  ASSERT_EQ(frames("whole").exitCode, 0);
  const auto rendering = start({"render", "r", "-o", "f", "--size", "160x240"});
  ASSERT_TRUE(rendering->waitForMessage(" of 51 pictures, "));
  rendering->send(GetParam());
  const Outcome stopped = rendering->wait();
  EXPECT_TRUE(stopped.exitCode == 130 || stopped.exitCode == 0);  // it may have been done
  const Files whole = filesIn(folder / "whole");
  for (const auto& [name, bytes] : filesIn(folder / "f")) EXPECT_TRUE(bytes == whole.at(name)) << name;
  ASSERT_EQ(frames("f").exitCode, 0);
  EXPECT_TRUE(filesIn(folder / "f") == whole);
}

INSTANTIATE_TEST_SUITE_P(Signals, RenderingFaultsStop, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace bedmix
