// SPDX-License-Identifier: MIT
#pragma once

#include "replay/file_trouble.h"

#include <exception>
#include <filesystem>
#include <string>
#include <utility>

namespace bedmix {

/// Why a foreign file cannot be read. Thrown inside the readers only; their public functions turn it into the
/// Diagnostic it holds.
struct ForeignError : std::exception {
  explicit ForeignError(Diagnostic d) : why(std::move(d)) {}
  ForeignError(const std::filesystem::path& path, std::string message)
      : why(fileTrouble(path, std::move(message))) {}
  ForeignError(SourceLocation at, std::string message)
      : why(std::move(at), std::move(message), Trouble::file) {}
  const char* what() const noexcept override { return why.message.c_str(); }

  Diagnostic why;
};

}  // namespace bedmix
