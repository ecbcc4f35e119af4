// SPDX-License-Identifier: MIT
#include "replay/export/export_format.h"

#include "engine/core/near_miss.h"
#include "replay/export/csv_export.h"
#include "replay/export/particle_text.h"
#include "replay/export/vtk_export.h"
#include "replay/export/xdmf_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace bedmix {

namespace {

constexpr std::array formats{
    ExportFormat{"vtk", "a .vtp of particles and a .vtr of gas a frame, listed in .pvd",
                 "ParaView, VisIt, VTK", VtkExport::open},
    ExportFormat{"xdmf", "descriptions that point into trajectory.h5, no copy of it", "ParaView, VisIt",
                 XdmfExport::open},
    ExportFormat{"csv", "one long table of particles, one of gas", "pandas, R, MATLAB", CsvExport::open},
    ExportFormat{"extxyz", "particles, extended XYZ", "OVITO, ASE", openExtxyz},
    ExportFormat{"lammps", "particles, a LAMMPS dump", "OVITO, VMD, LAMMPS tools", openLammps},
};

}  // namespace

std::span<const ExportFormat> exportFormats() { return formats; }

Result<const ExportFormat*> findExportFormat(std::string_view name) {
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const ExportFormat& f) { return f.name == name; });
  if (found != formats.end()) return &*found;
  std::vector<std::string> known;
  std::string table;
  for (const ExportFormat& f : formats) {
    known.emplace_back(f.name);
    table += fmt::format("\n  {:<8}{} (for {})", f.name, f.what, f.programs);
  }
  return Diagnostic{{},
                    fmt::format("there is no format \"{}\"{}; there are{}", name,
                                didYouMean(std::string(name), known), table)};
}

}  // namespace bedmix
