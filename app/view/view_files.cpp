// SPDX-License-Identifier: MIT
#include "app/view/view_files.h"

#include "app/png_text.h"
#include "app/run_folder.h"
#include "app/view/view_session.h"
#include "engine/core/scene_reader.h"
#include "render/painter.h"

#include <fmt/format.h>

#include <fstream>

namespace bedmix {

Result<std::filesystem::path> ViewFiles::nextFree(const char* name, const char* ending) const {
  if (const auto made = makeFolder(folder_); !made) return made.problems;
  for (int n = 1;; ++n) {
    std::filesystem::path path = folder_ / fmt::format("{}-{}.{}", name, n, ending);
    if (std::error_code error; !std::filesystem::exists(path, error)) return path;
  }
}

SavedFile ViewFiles::note(const std::filesystem::path& path) {
  names_.push_back(path.filename().string());
  return {names_.back(), path};
}

Result<SavedFile> ViewFiles::savePicture(const std::vector<ViewBed>& beds, const Style& style) {
  std::vector<PaintedBed> painted;
  std::vector<const Frame*> frames;
  for (const ViewBed& bed : beds) {
    if (!bed.frame) return Diagnostic{{}, "there is nothing to save yet"};
    painted.push_back({*bed.scene, bed.name});
    frames.push_back(bed.frame.get());
  }
  const auto path = nextFree("picture", "png");
  if (!path) return path.problems;
  auto painter = Painter::create(std::move(painted), {{}, style, 0, {}});
  if (!painter) return painter.problems;
  Image image;
  if (const auto done = painter->paint(frames, image); !done) return done.problems;
  const PngOptions png{
      .small = true, .text = withFrame(pngText(*beds.front().scene), *beds.front().frame), .dpi = {}};
  if (const auto written = writePng(*path, image, png); !written) return written.problems;
  return note(*path);
}

Result<SavedFile> ViewFiles::saveScene(Scene scene, const Style& style) {
  const auto path = nextFree("scene", "toml");
  if (!path) return path.problems;
  scene.pictures = style;
  std::ofstream file(*path, std::ios::binary);
  file << writeScene(scene);
  file.close();
  if (!file) return Diagnostic{{path->string()}, "cannot be written", Trouble::file};
  return note(*path);
}

}  // namespace bedmix
