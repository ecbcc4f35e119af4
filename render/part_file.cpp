// SPDX-License-Identifier: MIT
#include "render/part_file.h"

#include <utility>

namespace bedmix {

PartFile::PartFile(std::filesystem::path target, const char* suffix)
    : target_(std::move(target)), part_(target_.native() + suffix) {}

PartFile::~PartFile() {
  std::error_code ignored;  // it may never have been made
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

PartFile::PartFile(PartFile&& other) noexcept
    : target_(std::move(other.target_)), part_(std::exchange(other.part_, {})) {}

Result<Done> PartFile::keep() {
  std::error_code error;
  std::filesystem::rename(part_, target_, error);
  if (error) return failure(error.message());
  part_.clear();
  return Done{};
}

Diagnostic PartFile::failure(const std::string& why) const {
  return {{target_.string()}, "cannot write it: " + why, Trouble::file};
}

}  // namespace bedmix
