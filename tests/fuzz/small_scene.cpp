// SPDX-License-Identifier: MIT
#include "tests/fuzz/small_scene.h"

#include "engine/core/scene_reader.h"

#include <fstream>
#include <iterator>

namespace bedmix::fuzz {

Scene smallScene(bool effects) {
  std::ifstream in(BEDMIX_SOURCE_DIR "/assets/scenes/tiny.toml");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::vector<Override> overrides{{"particles.count", "12"}, {"start.arrangement", "drop"}};
  if (!effects) overrides.insert(overrides.end(), {{"gas", ""}, {"contacts.friction", ""}});
  return *readScene(text, "tiny.toml", overrides);
}

}  // namespace bedmix::fuzz
