// SPDX-License-Identifier: MIT
#pragma once

#include "replay/export/export_format.h"

namespace bedmix {

/// Particles in the "extended XYZ" of libAtoms (github.com/libAtoms/extxyz), all frames in one file. Species
/// are chemical symbols there: C for tracer, Cl for the rest, which viewers draw black and green.
Result<std::unique_ptr<Export>> openExtxyz(const ExportInput& input);

/// Particles as a text dump of LAMMPS (its documentation, "dump custom"), all frames in one file, in SI
/// units. Type 2 is tracer, type 1 the rest.
Result<std::unique_ptr<Export>> openLammps(const ExportInput& input);

}  // namespace bedmix
