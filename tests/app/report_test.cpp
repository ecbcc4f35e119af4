// SPDX-License-Identifier: MIT
#include "render/png.h"
#include "tests/app/program.h"

#include <algorithm>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

/// What a page is made of, read the strict way: an element that is not closed is an error.
struct Page {
  std::string error;              // the first; empty where it is well-formed
  std::string text;               // between tags, as it stands there
  std::vector<std::string> tags;  // opening ones, with their attributes
};

Page parse(const std::string& html) {
  Page page;
  std::vector<std::string> open;
  std::size_t at = html.find('>') + 1;  // after the document's type
  while (at < html.size() && page.error.empty()) {
    const std::size_t tag = std::min(html.find('<', at), html.size());
    page.text += html.substr(at, tag - at);
    if (tag == html.size()) break;
    const std::size_t end = html.find('>', tag);
    if (end == std::string::npos) {
      page.error = "a tag has no end";
      break;
    }
    const std::string inside = html.substr(tag + 1, end - tag - 1);
    at = end + 1;
    const std::string name = inside.substr(0, inside.find_first_of(" /", inside.front() == '/'));
    if (inside.front() == '/') {
      if (open.empty() || "/" + open.back() != inside) page.error = "closes what is not open: " + inside;
      if (!open.empty()) open.pop_back();
      continue;
    }
    page.tags.push_back(inside);
    if (inside.back() != '/') open.push_back(name);
  }
  if (page.error.empty() && !open.empty()) page.error = "is never closed: " + open.back();
  return page;
}

/// The value of an attribute; empty where the tag has none of that name.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(' ' + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t from = at + name.size() + 3;
  return tag.substr(from, tag.find('"', from) - from);
}

std::vector<std::string> tagsOf(const Page& page, const std::string& name) {
  std::vector<std::string> found;
  for (const std::string& tag : page.tags)
    if (tag == name || tag.starts_with(name + ' ')) found.push_back(tag);
  return found;
}

/// Bytes of a data URI.
std::string decoded(const std::string& uri) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (std::size_t i = uri.find(',') + 1; i < uri.size() && uri[i] != '='; ++i) {
    group = (group << 6 | static_cast<unsigned>(digits.find(uri[i]))) & 0xFFFFu;
    if ((bits += 6) < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xFFu);
  }
  return bytes;
}

std::set<std::string> filesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

class PipelineReport : public ProgramTest {
 protected:
  /// Runs the bundled scene `tiny` under another title.
  void runTiny(const std::string& title, const std::string& into) {
    const Outcome o = bedmix({"run", "tiny", "-o", into, "--set", "title=\"" + title + "\""});
    ASSERT_EQ(o.exitCode, 0) << o.err;
  }
};

TEST_F(PipelineReport, IsOnePageWithEverythingInside) {
  runTiny("<script>alert(1)</script> 1 < 2 & 'so'", "r");
  const Outcome o = bedmix({"report", "r", "-o", "out"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_EQ(
      filesIn(folder / "out"),
      (std::set<std::string>{"film.mp4", "flux.png", "flux.png.csv", "flux.png.gp", "mixing.png",
                             "mixing.png.csv", "mixing.png.gp", "pressure.png", "pressure.png.csv",
                             "pressure.png.gp", "report.html", "sampling.png", "sheet.png", "velocity.png"}));
  const std::string html = readFile(folder / "out/report.html");
  const Page page = parse(html);
  EXPECT_EQ(page.error, "");
  EXPECT_TRUE(tagsOf(page, "script").empty());
  EXPECT_TRUE(contains(page.text, "&lt;script&gt;alert(1)&lt;/script&gt; 1 &lt; 2 &amp; &#39;so&#39;"));

  const auto pictures = tagsOf(page, "img"), films = tagsOf(page, "video");
  EXPECT_EQ(pictures.size(), 6u);
  ASSERT_EQ(films.size(), 1u);
  EXPECT_TRUE(attribute(films[0], "src").starts_with("data:video/mp4;base64,"));
  EXPECT_TRUE(decoded(attribute(films[0], "src")) == readFile(folder / "out/film.mp4"));
  EXPECT_TRUE(decoded(attribute(pictures[0], "src")) == readFile(folder / "out/sheet.png"));
  for (const std::string& picture : pictures) {
    EXPECT_TRUE(attribute(picture, "src").starts_with("data:image/png;base64,iVBORw0KGgo"));
    EXPECT_GT(attribute(picture, "alt").size(), 10u);
  }
  EXPECT_FALSE(std::regex_search(html, std::regex("(src|href)=\"(?!data:)|url\\(|@import|https?:")));
  for (const char* said : {"Key numbers", "mixed: first A", "bed weight", "kg/(m² s)",
                           "integrator = ", "state hash", "neighbours", "friction", "0.1.0"})
    EXPECT_TRUE(page.text.find(said) != std::string::npos) << said;
}

TEST_F(PipelineReport, IsTheSameBytesTwice) {
  runTiny("twice", "r");
  ASSERT_EQ(bedmix({"report", "r", "-o", "a"}).exitCode, 0);
  ASSERT_EQ(bedmix({"report", "r", "-o", "b"}).exitCode, 0);
  for (const std::string& name : filesIn(folder / "a"))
    EXPECT_TRUE(readFile(folder / "a" / name) == readFile(folder / "b" / name)) << name;
}

TEST_F(PipelineReport, LeavesOutWhatARunDoesNotHave) {
  ASSERT_EQ(bedmix({"run", "settling", "-o", "s", "--until", "0.02"}).exitCode, 0);
  for (const char* name : {"s/summary.json", "s/mixing.csv"}) fs::remove(folder / name);
  const Outcome o = bedmix({"report", "s", "-o", "out"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  const auto files = filesIn(folder / "out");
  EXPECT_EQ(files,
            (std::set<std::string>{"film.mp4", "report.html", "sampling.png", "sheet.png", "velocity.png"}));
  const Page page = parse(readFile(folder / "out/report.html"));
  EXPECT_EQ(page.error, "");
  for (const char* said : {"Key numbers", "Mixing", "Solids flux", "Pressure drop", "state hash", "share"})
    EXPECT_EQ(page.text.find(said), std::string::npos) << said;
}

TEST_F(PipelineReport, ComparesRunsWithAndWithoutGas) {
  runTiny("fluidized", "gas/run");
  ASSERT_EQ(bedmix({"run", "settling", "-o", "still/run", "--until", "0.05"}).exitCode, 0);
  const Outcome o = bedmix({"report", "gas/run", "still/run", "-o", "out"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  const auto files = filesIn(folder / "out");
  for (const char* name : {"sheet.png", "compare.png", "pressure.png", "gas-run-mixing.png",
                           "still-run-mixing.png", "film.mp4", "still-run-velocity.png"})
    EXPECT_TRUE(files.contains(name)) << name;
  const Page page = parse(readFile(folder / "out/report.html"));
  EXPECT_EQ(page.error, "");
  EXPECT_EQ(tagsOf(page, "video").size(), 1u);  // side by side
}

TEST_F(PipelineReport, ReplacesItsOwnFilesOnly) {
  runTiny("again", "r");
  fs::create_directory(folder / "out");
  writeFile(folder / "out/notes.txt", "mine");
  writeFile(folder / "out/sheet.png", "an old one");
  ASSERT_EQ(bedmix({"report", "r", "-o", "out"}).exitCode, 0);
  EXPECT_EQ(readFile(folder / "out/notes.txt"), "mine");
  EXPECT_TRUE(readPng(folder / "out/sheet.png"));
  // A run's own folder is as good as any: its series keep their names.
  const std::string mixing = readFile(folder / "r/mixing.csv");
  ASSERT_EQ(bedmix({"report", "r", "-o", "r"}).exitCode, 0);
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), mixing);
  EXPECT_NE(readFile(folder / "r/mixing.png.csv"), mixing);
}

TEST_F(PipelineReport, SheetsOfRunsAreReadByFrame) {
  runTiny("one", "a");
  runTiny("other", "b");
  const Outcome o =
      bedmix({"sheet", "a", "b", "-o", "s.png", "--times", "0,0.05", "--layers", "voidage,walls"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_GT(readPng(folder / "s.png")->size.height, 800);
}

TEST_F(PipelineReport, PlotsSeedsAsABand) {
  for (const char* seed : {"1", "2", "3"})
    ASSERT_EQ(bedmix({"run", "tiny", "--seed", seed, "-o", std::string("s") + seed}).exitCode, 0);
  ASSERT_EQ(bedmix({"run", "tiny", "--set", "gas.density=1.0", "-o", "light"}).exitCode, 0);
  const Outcome o = bedmix({"plot", "s1", "s2", "light", "s3", "-o", "p.svg", "--kind", "flux", "--band"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  const std::string header = readFile(folder / "p.svg.csv");
  EXPECT_EQ(header.substr(0, header.find('\n')),
            "time,\"s1, 3 runs\",\"s1, 3 runs low\",\"s1, 3 runs high\","
            "\"light, 1 run\",\"light, 1 run low\",\"light, 1 run "
            "high\"");
}

class FaultsOfFigures : public ProgramTest {
 protected:
  void expectFault(int exitCode, const std::string& message, const std::vector<std::string>& arguments) {
    const Outcome o = bedmix(arguments);
    EXPECT_EQ(o.exitCode, exitCode) << ::testing::PrintToString(arguments);
    EXPECT_TRUE(contains(o.err, message)) << ::testing::PrintToString(arguments);
  }
};

TEST_F(FaultsOfFigures, AreExplainedAndLeaveNoFile) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r"}).exitCode, 0);
  const auto before = filesIn(folder);
  expectFault(4, "nowhere", {"report", "nowhere", "-o", "out"});
  expectFault(4, "nowhere", {"sheet", "r", "nowhere", "-o", "s.png"});
  expectFault(2, "--times: there is no frame at t = 9 s; the run goes from 0 to 0.05 s",
              {"sheet", "r", "-o", "s.png", "--times", "0,9"});
  expectFault(2, "did you mean \"particles\"?", {"sheet", "r", "-o", "s.png", "--layers", "particels"});
  expectFault(2, "--layers: hud and curve have no place in a sheet",
              {"sheet", "r", "-o", "s.png", "--layers", "hud"});
  expectFault(2, "--kind: there is no kind of plot 'histogram'",
              {"plot", "r", "-o", "p.png", "--kind", "histogram"});
  expectFault(4, "has no mixing.csv", {"plot", ".", "-o", "p.png"});
  expectFault(2, "give the file one of these endings", {"plot", "r", "-o", "p.bmp"});
  expectFault(4, "cannot write it", {"plot", "r", "-o", "no/such/p.png"});
  expectFault(4, "no/such/s.png", {"sheet", "r", "-o", "no/such/s.png"});
  writeFile(folder / "file", "");
  expectFault(4, "is a file; give a folder with -o", {"report", "r", "-o", "file"});
  fs::remove(folder / "file");
  EXPECT_EQ(filesIn(folder), before);
}

TEST_F(FaultsOfFigures, WithoutGnuplotThereAreNoCurves) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r"}).exitCode, 0);
  const Outcome plot = shell("PATH=/nowhere \"$BEDMIX\" plot r -o p.png");
  EXPECT_EQ(plot.exitCode, 5);
  EXPECT_TRUE(contains(plot.err, "install gnuplot-nox"));
  const Outcome report = shell("PATH=/nowhere \"$BEDMIX\" report r -o out");
  EXPECT_EQ(report.exitCode, 5);
  EXPECT_TRUE(contains(report.err, "install gnuplot-nox"));
  EXPECT_FALSE(fs::exists(folder / "p.png") || fs::exists(folder / "p.png.csv"));
  EXPECT_FALSE(fs::exists(folder / "out/report.html"));
}

}  // namespace
}  // namespace bedmix
