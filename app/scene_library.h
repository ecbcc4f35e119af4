// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "engine/core/scene_reader.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bedmix {

/// The bundled scenes by name, in alphabetical order: those installed beside the program, or those of the
/// sources it was built from.
std::vector<std::filesystem::path> bundledScenes();

/// The text of a file, or why it cannot be read.
Result<std::string> readTextFile(const std::filesystem::path& path);

/// "path=value" of --set, one each.
Result<std::vector<Override>> settingOverrides(const std::vector<std::string>& settings);

/// The file a scene is in: `scene` is the path of one or the name of a bundled one.
Result<std::filesystem::path> findScene(const std::string& scene);

/// Reads a scene given by path or bundled name.
Result<Scene> loadScene(const std::string& scene, const std::vector<Override>& overrides = {});

}  // namespace bedmix
