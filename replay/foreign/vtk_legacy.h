// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/vtk_points.h"

#include <filesystem>
#include <string_view>

namespace bedmix {

/// Points of a legacy .vtk file with POLYDATA or an UNSTRUCTURED_GRID, ASCII or BINARY. Throws ForeignError.
VtkPoints readVtkLegacy(std::string_view text, const std::filesystem::path& path);

}  // namespace bedmix
