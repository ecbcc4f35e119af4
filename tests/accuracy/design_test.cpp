// SPDX-License-Identifier: MIT
#include "app/accuracy/design.h"

#include "tests/accuracy/small_scene.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace bedmix {
namespace {

Design designOf(const Scene& scene) {
  Result<Design> design = designFor(scene);
  EXPECT_TRUE(design) << toString(design.problems[0]);
  return std::move(*design);
}

std::set<std::string> namesOf(const Design& design) {
  std::set<std::string> names;
  for (const Setting& s : design.settings)
    EXPECT_TRUE(names.insert(s.name).second) << s.name << " is there twice";
  return names;
}

TEST(Design, HoldsEverySettingItSpeaksOf) {
  const Design design = designOf(tinyScene());
  const std::set<std::string> names = namesOf(design);
  for (const Sweep& sweep : design.sweeps) {
    EXPECT_TRUE(names.contains(sweep.reference)) << sweep.knob;
    EXPECT_FALSE(sweep.turns.empty()) << sweep.knob;
    for (const Sweep::Turn& turn : sweep.turns) EXPECT_TRUE(names.contains(turn.setting)) << sweep.knob;
  }
  for (const std::string& name : design.statistics) EXPECT_TRUE(names.contains(name)) << name;
  for (const std::string& name : {design.standard, design.paper, design.reference})
    EXPECT_TRUE(names.contains(name));
  EXPECT_EQ(design.settings.front().name, sceneItself);
}

TEST(Design, TriesEveryIntegratorAndSchemeFromTooCoarseToFine) {
  const Scene scene = tinyScene();
  const Design design = designOf(scene);
  for (const ModelInfo& integrator : modelTable<Integrator>) {
    const auto sweep = std::find_if(design.sweeps.begin(), design.sweeps.end(), [&](const Sweep& s) {
      return s.knob == "time.step, " + std::string(integrator.name);
    });
    ASSERT_NE(sweep, design.sweeps.end()) << integrator.name;
    const auto [finest, coarsest] =
        std::minmax_element(sweep->turns.begin(), sweep->turns.end(),
                            [](const auto& a, const auto& b) { return a.value < b.value; });
    EXPECT_GT(coarsest->value, longestStep(scene));
    EXPECT_LT(finest->value, contactTimeScale(scene) / 390.0);
  }
  EXPECT_TRUE(namesOf(design).contains("gas.scheme=simple"));
}

// `run --set` with a setting's name makes that setting.
TEST(Design, NamesAreWhatMakesTheSettings) {
  const Scene scene = tinyScene();
  const std::string text = writeScene(scene);
  for (const Setting& setting : designOf(scene).settings) {
    if (setting.name == sceneItself || setting.name.starts_with("accuracy=")) continue;
    std::vector<Override> overrides;
    std::istringstream words(setting.name);
    for (std::string word; words >> word;)
      overrides.push_back({word.substr(0, word.find('=')), word.substr(word.find('=') + 1)});
    const Result<Scene> made = readScene(text, "tiny", overrides);
    const StepLength step = setting.scene.time.step;
    if (!step.isAutomatic() && step > longestStep(setting.scene))
      continue;  // refused, and tried all the same
    ASSERT_TRUE(made) << setting.name << ": " << made.problems[0].message;
    EXPECT_EQ(writeScene(*made), writeScene(setting.scene)) << setting.name;
  }
}

TEST(Design, WithoutGasTurnsNoGas) {
  Scene scene = tinyScene();
  scene.gas.reset();
  const Design design = designOf(scene);
  for (const std::string& name : namesOf(design)) EXPECT_EQ(name.find("gas."), std::string::npos) << name;
}

TEST(Design, OfAChosenStepTurnsKnobsFromAUsualOne) {
  Scene scene = tinyScene();
  scene.time.step = StepLength::automatic();
  scene.gas->step = StepLength::automatic();
  const Design design = designOf(scene);
  EXPECT_TRUE(design.find(sceneItself).scene.time.step.isAutomatic());
  for (const Sweep& sweep : design.sweeps) {
    if (!sweep.knob.starts_with("time.step")) continue;
    for (const Sweep::Turn& turn : sweep.turns)
      EXPECT_EQ(static_cast<double>(design.find(turn.setting).scene.time.step), turn.value);
  }
}

}  // namespace
}  // namespace bedmix
