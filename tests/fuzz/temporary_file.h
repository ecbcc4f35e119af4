// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace bedmix::fuzz {

/// A file of this process, removed at its end.
class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() / ("bedmix-fuzz-" + std::to_string(getpid()) + ".h5")) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline const std::filesystem::path& temporaryPath() {
  static const TemporaryFile file;
  return file.path();
}

inline void writeTemporary(const std::uint8_t* data, std::size_t size) {
  std::ofstream(temporaryPath(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

}  // namespace bedmix::fuzz
