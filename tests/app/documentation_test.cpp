// SPDX-License-Identifier: MIT
#include "engine/core/scene_keys.h"
#include "tests/app/program.h"

#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class Documentation : public ProgramTest {};

/// All group-1 matches of a pattern.
std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) found.insert((*it)[1]);
  return found;
}

std::set<std::string> commands(const Outcome& help) {
  return matches(help.out.substr(help.out.find("Subcommands:")), "\n  ([a-z]+)  ");
}

TEST_F(Documentation, EveryCommandHasHelpWithAnExample) {
  const auto names = commands(bedmix({"--help"}));
  EXPECT_EQ(names,
            (std::set<std::string>{"accuracy", "check", "completion", "doctor", "export", "plot", "recover",
                                   "render", "replay", "report", "run", "scenes", "sheet", "view"}));
  for (const std::string& name : names) {
    const Outcome help = bedmix({name, "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_TRUE(contains(help.out, "Example"));
    EXPECT_TRUE(contains(help.out, "  bedmix " + name) || contains(help.out, "(bedmix " + name)) << help.out;
  }
}

/// The lines of a document that call the program.
std::set<std::string> calls(const std::string& text) {
  return matches(text, "\n *(?:\\$ )?(?:build/release/)?(bedmix [^\n]*)");
}

std::vector<fs::path> allDocuments() {
  std::vector<fs::path> documents{BEDMIX_SOURCE_DIR "/README.md"};
  for (const auto& entry : fs::directory_iterator(BEDMIX_SOURCE_DIR "/assets/docs"))
    if (entry.path().extension() == ".md") documents.push_back(entry.path());
  return documents;
}

TEST_F(Documentation, WhatDocumentsCallExists) {
  const auto names = commands(bedmix({"--help"}));
  EXPECT_GE(allDocuments().size(), 6u);
  for (const fs::path& document : allDocuments()) {
    for (const std::string& call : calls(readFile(document))) {
      const auto command = matches(call, "^bedmix ([a-z]+)");
      if (command.empty()) continue;  // bedmix --version
      ASSERT_TRUE(names.contains(*command.begin())) << document << ": " << call;
      const std::string help = bedmix({*command.begin(), "--help"}).out + bedmix({"--help"}).out;
      for (const std::string& option : matches(call, " (--[a-z-]+)"))
        EXPECT_TRUE(contains(help, option)) << call;
    }
  }
}

TEST_F(Documentation, LinksOfDocumentsLeadSomewhere) {
  for (const fs::path& document : allDocuments()) {
    for (const std::string& link : matches(readFile(document), "\\]\\(([^)#:]+)\\)"))
      EXPECT_TRUE(fs::exists(document.parent_path() / link)) << document << " links " << link;
  }
}

TEST_F(Documentation, TheExampleInPythonDerivesTheRecordedIndex) {
  const std::string python = "/usr/bin/python3";
  if (shell(python + " -c 'import h5py, matplotlib, tomllib'").exitCode != 0)
    GTEST_SKIP() << python << " has no h5py, no matplotlib or is older than 3.11";
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out/even", "--until", "0.2"}).exitCode, 0);
  const std::string document = readFile(BEDMIX_SOURCE_DIR "/assets/docs/export.md"), begin = "```python\n";
  const std::size_t from = document.find(begin) + begin.size();
  writeFile(folder / "example.py", document.substr(from, document.find("```", from) - from) +
                                       "assert len(time) == 21 and np.all(np.isfinite(recorded))\n"
                                       "assert np.allclose(derived, recorded, rtol=1e-12)\n");
  const Outcome o = shell(python + " example.py");
  EXPECT_EQ(o.exitCode, 0) << o.err;
  EXPECT_TRUE(fs::exists(folder / "lacey.png"));
}

TEST_F(Documentation, SceneReferenceHasEveryKeyWithItsMeaning) {
  const std::string reference = readFile(BEDMIX_SOURCE_DIR "/assets/docs/scenes.md");
  for (const SceneKey& key : sceneKeys())
    EXPECT_TRUE(contains(reference, "| `" + key.path + "` | " + std::string(key.key.meaning))) << key.path;
}

}  // namespace
}  // namespace bedmix
