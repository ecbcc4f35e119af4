// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/vtk_points.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace bedmix {

/// Points of a .vtp or .vtu file: ascii, binary or appended, packed by zlib or not. Throws ForeignError.
VtkPoints readVtkXml(std::string_view text, const std::filesystem::path& path);

/// One file of a collection.
struct PvdEntry {
  double time = 0.0;  // s
  std::filesystem::path path;
};
/// The files of a .pvd collection, which must be in its folder or below. Throws ForeignError.
std::vector<PvdEntry> readPvd(std::string_view text, const std::filesystem::path& path);

}  // namespace bedmix
