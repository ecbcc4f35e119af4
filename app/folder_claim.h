// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <memory>

namespace bedmix {

/// Held by whoever writes into a folder, so that no other program does.
using FolderClaim = std::shared_ptr<const void>;

/// Fails where another program holds it. The folder itself is locked: nothing is left behind, whatever ends
/// the program. A file system without locks gives everyone one.
Result<FolderClaim> claimFolder(const std::filesystem::path& path);

}  // namespace bedmix
