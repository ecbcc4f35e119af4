// SPDX-License-Identifier: MIT
#include "replay/foreign/packed_file.h"

#include "replay/foreign/foreign_error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace bedmix {

namespace {

constexpr unsigned bufferSize = 1u << 16, mostAtOnce = 1u << 30;

}  // namespace

PackedFile::PackedFile(const std::filesystem::path& path) : path_(path), file_(gzopen(path.c_str(), "rb")) {
  if (!file_) throw ForeignError(path, std::string("cannot be read: ") + std::strerror(errno));
  gzbuffer(file_.get(), bufferSize);
}

std::size_t PackedFile::read(char* into, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const int n = gzread(file_.get(), into + done,
                         static_cast<unsigned>(std::min<std::size_t>(size - done, mostAtOnce)));
    if (n < 0) {
      int error = Z_OK;
      const char* reason = gzerror(file_.get(), &error);
      throw ForeignError(
          path_, std::string("cannot be read: ") + (error == Z_ERRNO ? std::strerror(errno) : reason));
    }
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

std::string_view PackedFile::text(std::uint64_t offset, std::size_t size) {
  if (text_.size() < size) text_.resize(size);
  if (gzseek(file_.get(), static_cast<z_off_t>(offset), SEEK_SET) < 0 || read(text_.data(), size) < size)
    throw ForeignError(path_, "has become shorter while it was read; open it once more");
  return std::string_view(text_).substr(0, size);
}

}  // namespace bedmix
