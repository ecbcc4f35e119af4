// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// Points of a VTK file and what stands at them.
struct VtkPoints {
  struct Array {
    std::string name;
    std::size_t components = 1;
    std::vector<double> values;
  };
  std::vector<double> coordinates;  // x, y, z of one point after the other
  std::vector<Array> arrays;
};

/// Kinds of numbers in VTK files, by their names in XML ("Float32") and legacy files ("float").
struct VtkNumber {
  bool isFloat = false, isSigned = false;
  std::size_t size = 0;  // bytes
};
/// Fails where there is no such kind. Failures in this file throw ForeignError.
VtkNumber vtkNumber(std::string_view name, const SourceLocation& at);

/// Numbers from bytes of that kind, in the order of bytes of this machine or in the other.
std::vector<double> vtkNumbers(std::string_view bytes, VtkNumber kind, bool isSwapped);

/// Particles from points, by the names of their arrays in capitals or not. Fails on numbers that are not
/// finite, on arrays of another length than the points, and on ids that are not whole or stand twice.
ForeignFrame toFrame(const VtkPoints& points, const SourceLocation& at);

}  // namespace bedmix
