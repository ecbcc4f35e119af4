// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <zlib.h>

namespace bedmix {

/// The bytes of a file, or what gzip made it of. Going forward is quick; in a gzip'd file going back begins
/// anew. Failures throw ForeignError.
class PackedFile {
 public:
  explicit PackedFile(const std::filesystem::path& path);

  /// Reads up to `size` bytes; fewer at the end only, also where a gzip'd file is cut off.
  std::size_t read(char* into, std::size_t size);
  /// Bytes from `offset` on, all of which have been there before. Valid until the next call.
  std::string_view text(std::uint64_t offset, std::size_t size);

 private:
  struct Closer {
    void operator()(gzFile_s* file) const { gzclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<gzFile_s, Closer> file_;
  std::string text_;  // never shrinks: new memory costs more than reading into it
};

}  // namespace bedmix
