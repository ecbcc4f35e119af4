// SPDX-License-Identifier: MIT
#include "app/scene_library.h"

#include "engine/core/near_miss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

fs::path sceneFolder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path().parent_path() / "share/bedmix/scenes";
  return fs::is_directory(installed, none) ? installed : fs::path(BEDMIX_SOURCE_SCENES);
}

}  // namespace

std::vector<fs::path> bundledScenes() {
  std::vector<fs::path> scenes;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(sceneFolder(), none))
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

Result<std::string> readTextFile(const fs::path& path) {
  std::error_code none;
  if (fs::is_directory(path, none)) return Diagnostic{{path.string()}, "is a folder", Trouble::file};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    return Diagnostic{
        {path.string()}, fmt::format("cannot be read: {}", std::strerror(errno)), Trouble::file};
  return text.str();
}

Result<std::vector<Override>> settingOverrides(const std::vector<std::string>& settings) {
  std::vector<Override> overrides;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      return Diagnostic{{"--set " + setting}, "must be path=value, e.g. --set gas.step=5e-5"};
    overrides.push_back({setting.substr(0, equals), setting.substr(equals + 1)});
  }
  return overrides;
}

Result<fs::path> findScene(const std::string& scene) {
  std::error_code none;
  const fs::path asPath(scene);
  if (fs::exists(asPath, none) && !fs::is_directory(asPath, none)) return asPath;
  const bool isName = !scene.empty() && !asPath.has_parent_path() && asPath.extension() != ".toml";
  std::vector<std::string> names;
  for (const fs::path& bundled : bundledScenes()) {
    names.push_back(bundled.stem().string());
    if (isName && names.back() == scene) return bundled;
  }
  if (!isName) return Diagnostic{{scene}, "there is no such scene file"};
  return Diagnostic{{scene},
                    fmt::format("there is no such file and no bundled scene of this name ({}){}",
                                fmt::join(names, ", "), didYouMean(scene, names))};
}

Result<Scene> loadScene(const std::string& scene, const std::vector<Override>& overrides) {
  const Result<fs::path> path = findScene(scene);
  if (!path) return path.problems;
  const Result<std::string> text = readTextFile(*path);
  if (!text) return text.problems;
  return readScene(*text, path->string(), overrides);
}

}  // namespace bedmix
