// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>

namespace bedmix {

/// Copies the packets of a fragmented MP4 into a plain one whose index comes first, so that it starts at once
/// when streamed, and gives it the name `target` when it is complete.
Result<Done> remuxMp4(const std::filesystem::path& fragmented, const std::filesystem::path& target);

}  // namespace bedmix
