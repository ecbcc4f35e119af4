// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// One snapshot of a LAMMPS dump.
struct LammpsSnapshot {
  std::int64_t step = 0;
  std::optional<double> time;  // s
  ForeignBox box;
  std::size_t particles = 0;

  std::size_t file = 0;      // which of the files it stands in
  std::int64_t line = 0;     // of its first particle's row
  std::uint64_t offset = 0;  // of that row, in bytes
  std::size_t size = 0;      // of all its rows, in bytes
};

/// Where the snapshots stand in a file, in their order; their `file` is left open.
struct LammpsIndex {
  std::vector<LammpsSnapshot> snapshots;
  std::string columns;  // their names, the same in all snapshots
  SourceLocation columnsAt;
};

/// Goes through a file once. Throws ForeignError where it is no dump that can be read.
LammpsIndex indexLammpsDump(const std::filesystem::path& path);

}  // namespace bedmix
