// SPDX-License-Identifier: MIT
#include "replay/analysis/analysis.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace bedmix::test {
namespace {

TEST(Analyses, AreChosenByNameOrAsFarAsTheSceneHasWhatTheyNeed) {
  const Scene dry = syntheticScene(false, false), wet = syntheticScene(true, false);
  Scene fed = wet;
  addFeed(fed);
  EXPECT_EQ(chooseAnalyses("all", fed)->size(), analysisKinds().size());
  EXPECT_EQ(chooseAnalyses("all", wet)->size(), analysisKinds().size() - 1);
  EXPECT_LT(chooseAnalyses("all", dry)->size(), analysisKinds().size() - 1);
  EXPECT_EQ(chooseAnalyses("flux,dispersion,flux", dry)->size(), 2u);
  const auto lacking = chooseAnalyses("bubbles", dry);
  ASSERT_FALSE(lacking);
  EXPECT_EQ(lacking.problems.front().message, "\"bubbles\" needs gas");
  const auto unknown = chooseAnalyses("dispersoin", dry);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.problems.front().message.find("did you mean \"dispersion\""), std::string::npos)
      << unknown.problems.front().message;
}

TEST(Analyses, WriteTablesAndFindingsOfDifferentNames) {
  const Scene scene = syntheticScene(true, false);
  std::set<std::string> names{"mixing", "flux", "pressure"};  // what a run writes
  for (const AnalysisKind& kind : analysisKinds()) {
    const auto analysis = kind.make({scene, 1, 0.0});
    for (const NamedTable& made : analysis->tables())
      EXPECT_TRUE(names.insert(made.name).second) << made.name;
    for (const FoundNumber& f : analysis->findings())
      EXPECT_TRUE(names.insert("finding " + f.name).second) << f.name;
  }
}

/// Every value is a number or not there, and columns are of one length.
void expectSound(const Analysis& analysis, std::string_view name) {
  for (const NamedTable& made : analysis.tables()) {
    EXPECT_EQ(made.table.names.size(), made.table.columns.size()) << made.name;
    for (const Table::Column& column : made.table.columns) {
      EXPECT_EQ(column.size(), made.table.rows()) << made.name;
      for (const auto& value : column) EXPECT_TRUE(!value || std::isfinite(*value)) << made.name;
    }
  }
  for (const FoundNumber& f : analysis.findings())
    EXPECT_TRUE(!f.value || std::isfinite(*f.value)) << name << ": " << f.name;
}

TEST(Analyses, TakeFramesOfAnyNumberOfParticles) {
  const Scene scene = syntheticScene(true, true);
  for (const AnalysisKind& kind : analysisKinds()) {
    for (const int frames : {0, 1, 2, 40}) {
      const std::size_t expected = static_cast<std::size_t>(std::max(frames, 1));
      const auto changing = kind.make({scene, expected, frames > 1 ? 0.01 : 0.0});
      const auto none = kind.make({scene, expected, frames > 1 ? 0.01 : 0.0});
      for (int i = 0; i < frames; ++i) {
        Frame frame = without(syntheticFrame(scene, i), 1 + i % 4);  // none at all every fourth time
        frame.gas = syntheticFrame(scene, i).gas;
        changing->accept(frame);
        Frame bare;
        bare.time = frame.time;
        none->accept(bare);
      }
      expectSound(*changing, kind.name);
      expectSound(*none, kind.name);
    }
  }
}

}  // namespace
}  // namespace bedmix::test
