// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <string>

namespace bedmix {

/// Copies the packets of a fragmented MP4 into a plain one whose index comes first, so that it starts at once
/// when streamed, and gives it the name `target` when it is complete.
Result<Done> remuxMovie(const std::filesystem::path& fragmented, const std::filesystem::path& target);

/// libav's words for one of its error codes.
std::string libavError(int error);

}  // namespace bedmix
