// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace bedmix {

/// A new file that grows piece by piece and is whole after each: what stands behind the last piece (closing
/// tags, say) is written with it. A piece for which there is no room leaves it as it was.
class GrowingFile {
 public:
  /// Fails where anything of that name is there.
  static Result<GrowingFile> create(const std::filesystem::path& path, std::string_view head,
                                    std::string tail = "");
  GrowingFile(GrowingFile&& other) noexcept;
  ~GrowingFile();

  std::optional<Diagnostic> append(std::string_view piece);
  const std::filesystem::path& path() const { return path_; }

 private:
  GrowingFile(std::filesystem::path path, std::string tail, int descriptor)
      : path_(std::move(path)), tail_(std::move(tail)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  std::string tail_;
  int descriptor_;
  std::uint64_t end_ = 0;  // of the last piece
};

/// Makes a file of these bytes. Fails likewise, and then leaves none.
std::optional<Diagnostic> writeNewFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace bedmix
