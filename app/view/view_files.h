// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_model.h"
#include "engine/core/diagnostic.h"
#include "render/style.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bedmix {

struct SavedFile;

/// The files a person saves from the panel: picture-1.png, scene-1.toml, ... in one folder, which is made
/// when the first is. Names are chosen here and nowhere else; none that is there is written over.
class ViewFiles {
 public:
  explicit ViewFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The beds without the panel, as `bedmix render` draws them.
  Result<SavedFile> savePicture(const std::vector<ViewBed>& beds, const Style& style);
  /// The scene with the style as its [pictures].
  Result<SavedFile> saveScene(Scene scene, const Style& style);
  const std::vector<std::string>& names() const { return names_; }

 private:
  Result<std::filesystem::path> nextFree(const char* name, const char* ending) const;
  SavedFile note(const std::filesystem::path& path);

  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

}  // namespace bedmix
