// SPDX-License-Identifier: MIT
#include "app/accuracy/study.h"

#include "app/accuracy/findings.h"
#include "tests/accuracy/small_scene.h"

#include <algorithm>
#include <limits>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class StudyOfTiny : public testing::Test {
 protected:
  StudyOfTiny()
      : scene_(tinyScene()),
        folder_(fs::temp_directory_path() / ("bedmix_study_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    console_.quiet = true;
    scene_.time.duration = 0.02;
    design_ = *designFor(scene_);
    // The presets, and one that must fail.
    Scene unstable = scene_;
    unstable.time.step = 5e-4;  // T/2
    unstable.gas->step = 5e-4;
    const std::string fails = settingName(scene_, unstable);
    std::erase_if(design_.settings,
                  [](const Setting& s) { return s.name != sceneItself && !s.name.starts_with("accuracy="); });
    std::erase_if(design_.sweeps, [](const Sweep& s) { return s.knob != "accuracy"; });
    design_.settings.push_back({fails, unstable});
    design_.sweeps.front().turns.push_back({9.0, fails});
    design_.statistics = design_.presets;
    design_.statistics.push_back(fails);
    unstable_ = fails;
  }
  ~StudyOfTiny() override { fs::remove_all(folder_); }

  SampleLog log(bool resume) const {
    return std::move(*SampleLog::open(folder_ / "accuracy.csv", "1", "tiny", resume));
  }

  Scene scene_;
  fs::path folder_;
  Console console_;
  Design design_;
  std::string unstable_;
};

TEST_F(StudyOfTiny, TakesEverySampleOnceAndReportsWhatFails) {
  std::size_t taken = 0;
  {
    SampleLog samples = log(false);
    Study study(scene_, design_, samples, console_,
                {std::numeric_limits<double>::infinity(), 2, 8, [] { return false; }});
    ASSERT_FALSE(study.run());
    EXPECT_EQ(study.samplesLeft(), 0);
    taken = samples.samples().size();
    std::set<SampleKey> keys;
    for (const Sample& s : samples.samples()) EXPECT_TRUE(keys.insert(s.key).second) << s.key.setting;
    const Findings findings(design_, samples.samples(), study.plan().duration);
    EXPECT_NE(findings.of(unstable_).failure.find("at t = "), std::string::npos)
        << findings.of(unstable_).failure;
    for (const std::string& preset : design_.presets) {
      EXPECT_TRUE(findings.of(preset).failure.empty()) << preset << ": " << findings.of(preset).failure;
      EXPECT_TRUE(findings.of(preset).cost) << preset;
      EXPECT_EQ(findings.of(preset).runs.at(measure::bedHeight.name).size(),
                preset == design_.paper ? 4u : 8u)
          << preset;
    }
    EXPECT_GT(*findings.growth(), 0.0);
  }
  SampleLog samples = log(true);
  Study again(scene_, design_, samples, console_,
              {std::numeric_limits<double>::infinity(), 2, 8, [] { return false; }});
  ASSERT_FALSE(again.run());
  EXPECT_EQ(samples.samples().size(), taken);
}

TEST_F(StudyOfTiny, BeginsNothingWithoutBudgetOrWhenStopped) {
  for (const auto& [budget, stopped] : {std::pair{1e-6, false}, {1e6, true}}) {
    SampleLog samples = log(false);
    Study study(scene_, design_, samples, console_, {budget, 2, 8, [stopped = stopped] { return stopped; }});
    ASSERT_FALSE(study.run());
    EXPECT_TRUE(samples.samples().empty());
    EXPECT_GT(study.samplesLeft(), 0);
  }
}

}  // namespace
}  // namespace bedmix
