// SPDX-License-Identifier: MIT
#include "app/folder_claim.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

Diagnostic trouble(const fs::path& path, const std::string& message) {
  return {{path.string()}, message, Trouble::file};
}

}  // namespace

Result<FolderClaim> claimFolder(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return trouble(path, std::error_code(errno, std::generic_category()).message());
  FolderClaim claim(nullptr, [descriptor](const void*) { close(descriptor); });
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return trouble(path, "another bedmix is writing into this folder; wait for it or give another with -o");
  return claim;
}

}  // namespace bedmix
