// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

namespace bedmix {

/// What pictures go to, in order and all of one size: a film of some kind. What is not finished leaves
/// nothing.
class PictureWriter {
 public:
  virtual ~PictureWriter() = default;
  /// After a failure of either only the destructor may follow.
  virtual Result<Done> add(const Image& picture) = 0;
  virtual Result<Done> finish() = 0;
};

}  // namespace bedmix
