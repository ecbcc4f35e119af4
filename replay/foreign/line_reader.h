// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "replay/foreign/packed_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bedmix {

/// Lines of a text file, gzip'd or not, in order. A last line without its end, as a program that still writes
/// leaves it, is not counted. Failures throw ForeignError.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& path) : path_(path), file_(path) {}

  /// The next line without its end, valid until the next call; empty after the last.
  std::optional<std::string_view> next();
  /// The line that next() gave last, counted from 1.
  std::int64_t line() const { return line_; }
  SourceLocation at() const { return {path_.string(), static_cast<int>(line_), 1}; }
  /// Where the line begins that comes next, in bytes.
  std::uint64_t offset() const { return blockOffset_ + from_; }

 private:
  bool refill();

  std::filesystem::path path_;
  PackedFile file_;
  std::string block_;
  std::uint64_t blockOffset_ = 0;
  std::size_t from_ = 0;
  std::int64_t line_ = 0;
};

}  // namespace bedmix
