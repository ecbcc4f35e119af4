// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

#include <memory>
#include <span>

namespace bedmix {

/// Text dumps of LAMMPS and LIGGGHTS ("dump custom", "dump atom"), gzip'd or not: one file or a series in any
/// order, each with any number of snapshots. A snapshot that has no end yet is not counted. Where steps go
/// back, as when a run was resumed, what had been written of them before is left out. species is the type.
/// Fails on files that are something else, damaged, in units other than SI or in a box that is not
/// orthogonal.
Result<std::unique_ptr<ForeignSource>> openLammpsDump(std::span<const std::filesystem::path> paths);

}  // namespace bedmix
