// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <memory>

namespace bedmix {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file of the C library that is closed with its owner.
using CFile = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace bedmix
