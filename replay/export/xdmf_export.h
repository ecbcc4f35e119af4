// SPDX-License-Identifier: MIT
#pragma once

#include "replay/export/export_format.h"
#include "replay/export/growing_file.h"

#include <string>

namespace bedmix {

/// Descriptions (XDMF 2, www.xdmf.org) that point into the trajectory itself, by its path as seen from the
/// folder: particles.xmf and with gas gas.xmf. No number is copied.
class XdmfExport final : public Export {
 public:
  static Result<std::unique_ptr<Export>> open(const ExportInput& input);

  std::vector<std::filesystem::path> files() const override;

 private:
  XdmfExport(const ExportInput& input, GrowingFile particles);
  std::optional<Diagnostic> write(const Frame& frame) override;

  ExportInput input_;
  std::string file_;  // the trajectory, as XML
  std::size_t next_ = 0;
  GrowingFile particles_;
  std::optional<GrowingFile> gas_;
};

}  // namespace bedmix
