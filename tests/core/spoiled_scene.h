// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace bedmix::test {

/// What is done to a sound scene, and the one contradiction that must come of it.
struct Spoiled {
  const char* name;
  std::function<void(Scene&)> spoil;
  const char* path;
  const char* reason;
};

inline std::string nameOfSpoiled(const testing::TestParamInfo<Spoiled>& tried) { return tried.param.name; }

inline void expectReportedOnce(Scene scene, const Spoiled& spoiled) {
  spoiled.spoil(scene);
  const auto found = contradictions(scene);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].path, spoiled.path);
  EXPECT_NE(found[0].message.find(spoiled.reason), std::string::npos) << found[0].message;
}

}  // namespace bedmix::test
