// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_series.h"

#include "replay/foreign/foreign_error.h"
#include "replay/foreign/vtk_legacy.h"
#include "replay/foreign/vtk_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>

namespace bedmix {

namespace {

std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ForeignError(path, std::string("cannot be read: ") + std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw ForeignError(path, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

bool isPoints(const std::filesystem::path& path) {
  return path.extension() == ".vtp" || path.extension() == ".vtu" || path.extension() == ".vtk";
}

struct SeriesFile {
  std::int64_t step = 0;
  std::filesystem::path path;
};

/// The last number in the name; 0 where it has none.
std::int64_t stepOf(const std::filesystem::path& path) {
  const std::string name = path.stem().string();
  constexpr const char* digits = "0123456789";
  const std::size_t last = name.find_last_of(digits);
  if (last == std::string::npos) return 0;
  const std::size_t before = name.find_last_not_of(digits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  std::int64_t step = 0;
  if (std::from_chars(name.data() + first, name.data() + last + 1, step).ec != std::errc())
    throw ForeignError(path, "has a number in its name that is too long for a step");
  return step;
}

std::vector<SeriesFile> numbered(const std::vector<std::filesystem::path>& paths) {
  std::vector<SeriesFile> files;
  for (const std::filesystem::path& path : paths) {
    if (!isPoints(path)) throw ForeignError(path, "is no .pvd, .vtp, .vtu or .vtk file");
    files.push_back({stepOf(path), path});
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const SeriesFile& a, const SeriesFile& b) { return a.step < b.step; });
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].step == files[i - 1].step)
      throw ForeignError(files[i].path,
                         fmt::format("has the number {} in its name, as has {}; name the files of one "
                                     "series only",
                                     files[i].step, files[i - 1].path.string()));
  return files;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    // LIGGGHTS writes its box beside the particles.
    const bool isBox = entry->path().stem().string().find("boundingBox") != std::string::npos;
    if (isPoints(entry->path()) && !isBox) paths.push_back(entry->path());
  }
  if (error) throw ForeignError(folder, "cannot be read: " + error.message());
  if (paths.empty()) throw ForeignError(folder, "holds no .vtp, .vtu or .vtk file");
  std::sort(paths.begin(), paths.end());
  return paths;
}

class VtkSeries final : public ForeignSource {
 public:
  explicit VtkSeries(std::span<const std::filesystem::path> paths) {
    if (paths.empty()) throw ForeignError(std::filesystem::path(), "no file of VTK is named");
    const std::filesystem::path& first = paths.front();
    if (paths.size() == 1 && first.extension() == ".pvd") {
      for (PvdEntry& entry : readPvd(fileText(first), first)) {
        files_.push_back(std::move(entry.path));
        steps_.push_back(static_cast<std::int64_t>(steps_.size()));
        times_.push_back(entry.time);
      }
      return;
    }
    const bool isFolder = paths.size() == 1 && std::filesystem::is_directory(first);
    for (SeriesFile& file : numbered(isFolder ? filesIn(first) : std::vector(paths.begin(), paths.end()))) {
      files_.push_back(std::move(file.path));
      steps_.push_back(file.step);
    }
  }

  int dimensions() const override { return 3; }
  const std::vector<std::int64_t>& steps() const override { return steps_; }
  const std::vector<double>& times() const override { return times_; }
  std::optional<ForeignBox> box() const override { return std::nullopt; }

  Result<ForeignFrame> frame(std::size_t index) override {
    const std::filesystem::path& path = files_[index];
    try {
      const std::string text = fileText(path);
      return toFrame(path.extension() == ".vtk" ? readVtkLegacy(text, path) : readVtkXml(text, path),
                     {path.string()});
    } catch (const ForeignError& e) {
      return e.why;
    } catch (const std::bad_alloc&) {
      return fileTrouble(path, "is too large for the memory of this machine");
    }
  }

 private:
  std::vector<std::filesystem::path> files_;
  std::vector<std::int64_t> steps_;
  std::vector<double> times_;
};

}  // namespace

Result<std::unique_ptr<ForeignSource>> openVtkSeries(std::span<const std::filesystem::path> paths) {
  try {
    auto series = std::make_unique<VtkSeries>(paths);
    if (auto first = series->frame(0); !first) return first.problems;
    return std::unique_ptr<ForeignSource>(std::move(series));
  } catch (const ForeignError& e) {
    return e.why;
  }
}

}  // namespace bedmix
