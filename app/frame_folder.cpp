// SPDX-License-Identifier: MIT
#include "app/frame_folder.h"

#include "app/run_folder.h"
#include "render/png_info.h"

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

constexpr std::string_view prefix = "frame_", ending = ".png";

/// The number in a name like ours; none for others.
std::optional<std::size_t> numberIn(std::string_view name) {
  if (!name.starts_with(prefix) || !name.ends_with(ending)) return std::nullopt;
  name = name.substr(prefix.size(), name.size() - prefix.size() - ending.size());
  std::size_t number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  if (read.ec != std::errc{} || read.ptr != name.data() + name.size()) return std::nullopt;
  return number;
}

bool sameColors(const Image& a, const Image& b) {
  if (!(a.size == b.size)) return false;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    if (a.rgba[i] != b.rgba[i] || a.rgba[i + 1] != b.rgba[i + 1] || a.rgba[i + 2] != b.rgba[i + 2])
      return false;
  return true;
}

}  // namespace

Result<FrameFolder> FrameFolder::open(const fs::path& path, std::size_t pictures, bool force) {
  if (const auto made = makeFolder(path); !made) return made.problems;
  Result<FolderClaim> claim = claimFolder(path);
  if (!claim) return claim.problems;
  FrameFolder folder(path, std::move(*claim), pictures);
  if (Result<Done> done = folder.look(force); !done) return done.problems;
  return folder;
}

Result<Done> FrameFolder::look(bool force) {
  std::error_code error;
  for (fs::directory_iterator it(path_, error), end; !error && it != end; it.increment(error)) {
    const auto number = numberIn(it->path().filename().string());
    if (!number) continue;
    if (force) {
      std::error_code kept;
      if (fs::remove(it->path(), kept); kept)
        return Diagnostic{{it->path().string()}, "cannot be removed: " + kept.message(), Trouble::file};
    } else if (*number >= named_.size()) {
      return foreign(*number, fmt::format("this one ends with number {}", named_.size() - 1));
    } else {
      named_[*number] = true;
    }
  }
  if (error)
    return Diagnostic{{path_.string()}, "cannot read this folder: " + error.message(), Trouble::file};
  return Done{};
}

fs::path FrameFolder::file(std::size_t number) const {
  return path_ / fmt::format("{}{:06}{}", prefix, number, ending);
}

Result<bool> FrameFolder::holds(std::size_t number, Size size, const PngText& text) const {
  if (!named_[number]) return false;
  const auto info = readPngInfo(file(number));
  if (!info) return false;
  if (!(info->size == size))
    return foreign(number, fmt::format("it has {}x{} pixels, this one {}x{}", info->size.width,
                                       info->size.height, size.width, size.height));
  for (std::size_t i = 0; i < text.size(); ++i)
    if (i >= info->text.size() || info->text[i] != text[i])
      return foreign(number, fmt::format("{} is \"{}\", here \"{}\"", text[i].first,
                                         i < info->text.size() ? info->text[i].second : "", text[i].second));
  return true;
}

bool FrameFolder::besideGap(std::size_t number) const {
  const auto gap = [&](std::size_t at) { return at >= named_.size() || !named_[at]; };
  return number == 0 || gap(number - 1) || gap(number + 1);
}

Result<Done> FrameFolder::expect(std::size_t number, const Image& image) const {
  const auto there = readPng(file(number));
  if (!there) return there.problems;
  if (!sameColors(*there, image)) return foreign(number, "it looks different");
  return Done{};
}

Diagnostic FrameFolder::foreign(std::size_t number, const std::string& why) const {
  return {{file(number).string()},
          "belongs to another rendering: " + why + "; give another folder, or replace it with --force"};
}

}  // namespace bedmix
