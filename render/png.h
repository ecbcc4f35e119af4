// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bedmix {

/// tEXt: keywords (at most 79 characters) and values.
using PngText = std::vector<std::pair<std::string, std::string>>;

struct PngOptions {
  bool small = false;  // a figure: better compression; else quick, for frames
  PngText text;
  std::optional<double> dpi;  // pHYs
};

/// Writes 8-bit RGB; alpha is left out. Goes to `path`.part first and gets its name when all of it is on
/// disk; nothing stands under `path` after a failure that did not stand there before. No time stamp: the same
/// picture gives the same bytes.
Result<Done> writePng(const std::filesystem::path& path, const Image& image, const PngOptions& options = {});

/// Any PNG, as 8-bit RGBA.
Result<Image> readPng(const std::filesystem::path& path);

}  // namespace bedmix
