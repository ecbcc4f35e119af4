// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"
#include "render/png.h"

#include <filesystem>

namespace bedmix {

/// What a PNG says of itself.
struct PngInfo {
  Size size;
  PngText text;  // in order
};

/// Reads it without the pixels. Fails for a file that is no PNG or ends too early.
Result<PngInfo> readPngInfo(const std::filesystem::path& path);

}  // namespace bedmix
