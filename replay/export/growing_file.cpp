// SPDX-License-Identifier: MIT
#include "replay/export/growing_file.h"

#include "replay/file_trouble.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace bedmix {

namespace {

bool writeAll(int descriptor, std::string_view bytes, std::uint64_t at) {
  while (!bytes.empty()) {
    const ssize_t n = pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
  return true;
}

Diagnostic unwritten(const std::filesystem::path& path, const std::string& what) {
  return fileTrouble(path, std::string("cannot be written: ") + std::strerror(errno) + what);
}

}  // namespace

Result<GrowingFile> GrowingFile::create(const std::filesystem::path& path, std::string_view head,
                                        std::string tail) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST)
    return fileTrouble(path, "is there already; remove it, or give another folder");
  if (descriptor < 0) return unwritten(path, "");
  GrowingFile file(path, std::move(tail), descriptor);
  if (auto problem = file.append(head)) {
    unlink(path.c_str());
    return *problem;
  }
  return file;
}

GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_(std::move(other.path_)),
      tail_(std::move(other.tail_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      end_(other.end_) {}

GrowingFile::~GrowingFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::optional<Diagnostic> GrowingFile::append(std::string_view piece) {
  if (writeAll(descriptor_, std::string(piece) + tail_, end_)) {
    end_ += piece.size();
    return std::nullopt;
  }
  const Diagnostic problem =
      unwritten(path_, end_ > 0 ? "; what stands in it is whole up to its last frame" : "");
  // Needs no room, for the tail has stood there.
  if (writeAll(descriptor_, tail_, end_)) [[maybe_unused]]
    const int cut = ftruncate(descriptor_, static_cast<off_t>(end_ + tail_.size()));
  return problem;
}

std::optional<Diagnostic> writeNewFile(const std::filesystem::path& path, std::string_view bytes) {
  const Result<GrowingFile> file = GrowingFile::create(path, bytes);
  if (!file) return file.problems.front();
  return std::nullopt;
}

}  // namespace bedmix
