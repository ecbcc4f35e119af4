// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <string>
#include <utility>

namespace bedmix {

/// What is wrong with a file as a whole.
inline Diagnostic fileTrouble(const std::filesystem::path& path, std::string message) {
  return {{path.string()}, std::move(message), Trouble::file};
}

}  // namespace bedmix
