// SPDX-License-Identifier: MIT
#include "engine/core/scene_values.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

TEST(SceneValues, TellValueUnitAndChoicesOfEveryKey) {
  Scene scene;
  scene.gas.emplace().inlets = {{0.0, 0.05, 1.5, {}}, {0.05, 0.1, {}, 2.0}};
  const std::vector<SceneValue> values = sceneValues(scene);
  const auto value = [&](const std::string& path) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const SceneValue& v) { return v.path == path; });
    EXPECT_NE(found, values.end()) << path;
    return found == values.end() ? SceneValue{} : *found;
  };
  EXPECT_EQ(value("gravity").number, 9.81);
  EXPECT_EQ(value("gravity").key.unit, "m/s2");
  EXPECT_EQ(value("gas.inlets.0.velocity").number, 1.5);
  EXPECT_EQ(value("gas.inlets.1.velocity_umf").number, 2.0);
  EXPECT_EQ(value("gas.inlets.1.velocity_umf").key.unit, "u_mf");
  EXPECT_EQ(value("bed.top").choices, (std::vector<std::string_view>{"open", "lid"}));
  EXPECT_EQ(value("bed.top").text, "\"open\"");
  EXPECT_FALSE(value("bed.top").number);
  EXPECT_EQ(value("particles.count").number, 1000.0);
  EXPECT_TRUE(value("particles.count").choices.empty());
}

}  // namespace
}  // namespace bedmix
