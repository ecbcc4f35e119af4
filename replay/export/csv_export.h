// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "replay/export/export_format.h"
#include "replay/export/growing_file.h"

namespace bedmix {

/// Two long tables, as RFC 4180 has them but for the ends of lines, which are those of all tables here:
/// particles.csv, a row a particle and frame, and with gas gas.csv, a
/// row an open cell and frame. One table and not a file a frame, since that is what pandas, R and MATLAB read
/// at once; programs that draw have formats of their own.
class CsvExport final : public Export {
 public:
  static Result<std::unique_ptr<Export>> open(const ExportInput& input);

  std::vector<std::filesystem::path> files() const override;

 private:
  struct Gas {
    GasGrid grid;
    GrowingFile file;
  };
  CsvExport(GrowingFile particles, std::optional<Gas> gas)
      : particles_(std::move(particles)), gas_(std::move(gas)) {}
  std::optional<Diagnostic> write(const Frame& frame) override;

  GrowingFile particles_;
  std::optional<Gas> gas_;
};

}  // namespace bedmix
