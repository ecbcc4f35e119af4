// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_reader.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace bedmix {

/// The bundled scene for tests.
inline Scene tinyScene() {
  const std::string path = BEDMIX_SOURCE_DIR "/assets/scenes/tiny.toml";
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Result<Scene> scene = readScene(text, path);
  EXPECT_TRUE(scene) << toString(scene.problems[0]);
  return *scene;
}

}  // namespace bedmix
