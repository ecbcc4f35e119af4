// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace bedmix {

/// A file of the page, as it is served; from assets/viewer, put into the program when it is built.
struct PageFile {
  std::string_view path, type, content;
};
std::span<const PageFile> viewerPage();

}  // namespace bedmix
