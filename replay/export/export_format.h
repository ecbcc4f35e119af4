// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "replay/file_sink.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace bedmix {

/// What an export knows of the frames to come.
struct ExportInput {
  const Scene& scene;                 // outlives the export
  std::filesystem::path trajectory;   // the file they come from
  std::size_t recorded = 0;           // how many that holds
  std::vector<std::size_t> selected;  // the places there of those to come, in order
  std::filesystem::path folder;       // to write into; must be there
  bool isForeign = false;             // whether the file is another program's
};

/// Frames in another program's format. Writes no file that is there already. Numbers are those of the frames:
/// decimals read back to the same bits.
class Export : public FileSink {
 public:
  /// What to open in the other program, in the folder.
  virtual std::vector<std::filesystem::path> files() const = 0;
};

/// One selectable format: its name, what it writes, what for.
struct ExportFormat {
  std::string_view name;
  std::string_view what;
  std::string_view programs;
  Result<std::unique_ptr<Export>> (*open)(const ExportInput& input);
};

/// The table of all.
std::span<const ExportFormat> exportFormats();

/// The one of that name. Fails on others, with the table.
Result<const ExportFormat*> findExportFormat(std::string_view name);

}  // namespace bedmix
