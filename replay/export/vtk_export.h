// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "replay/export/export_format.h"
#include "replay/export/growing_file.h"

namespace bedmix {

/// A file a frame, particles_NNNNNN.vtp and with gas gas_NNNNNN.vtr by its place in the run; walls.vtp; and
/// particles.pvd and gas.pvd, which list the complete ones with their times.
class VtkExport final : public Export {
 public:
  static Result<std::unique_ptr<Export>> open(const ExportInput& input);

  std::vector<std::filesystem::path> files() const override;

 private:
  VtkExport(const ExportInput& input, GrowingFile particles);
  std::optional<Diagnostic> write(const Frame& frame) override;
  std::optional<Diagnostic> add(GrowingFile& list, const std::string& name, double time,
                                const std::string& bytes);

  std::filesystem::path folder_;
  std::vector<std::size_t> selected_;
  std::size_t next_ = 0;
  const Scene& scene_;
  GrowingFile particles_;
  std::optional<GasGrid> grid_;
  std::optional<GrowingFile> gas_;
};

}  // namespace bedmix
