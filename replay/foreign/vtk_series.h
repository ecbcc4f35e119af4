// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

#include <memory>
#include <span>

namespace bedmix {

/// Particles as points in VTK's files: a .pvd collection, which has times; or .vtp, .vtu and legacy .vtk
/// files, or a folder of them, whose steps are the last numbers in their names. Fails on others and where the
/// first frame cannot be read.
Result<std::unique_ptr<ForeignSource>> openVtkSeries(std::span<const std::filesystem::path> paths);

}  // namespace bedmix
