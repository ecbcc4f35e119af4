// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <string>
#include <string_view>

namespace bedmix {

/// How a VTK XML file holds binary numbers.
struct VtkCoding {
  std::size_t headerSize = 4;  // bytes of the lengths before the data
  bool isSwapped = false;      // against this machine's order of bytes
  bool isCompressed = false;   // in blocks, by zlib
};

/// The bytes of an array, whose coded form `text` begins with. What it says of its length is believed only as
/// far as `text` can hold it. Throws ForeignError.
std::string vtkBytes(std::string_view text, bool isBase64, const VtkCoding& coding, const SourceLocation& at);

}  // namespace bedmix
