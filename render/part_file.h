// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <string>

namespace bedmix {

/// A file that has its name only when it is complete: until keep() it is called `target`.part, and a PartFile
/// that goes away unkept takes it along.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path target, const char* suffix = ".part");
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  const std::filesystem::path& path() const { return part_; }
  /// Renames it; nothing may have it open for writing.
  Result<Done> keep();
  /// "cannot write FILE: why" as a problem of the file.
  Diagnostic failure(const std::string& why) const;

 private:
  std::filesystem::path target_, part_;
};

}  // namespace bedmix
