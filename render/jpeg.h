// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace bedmix {

/// Makes JPEGs of pictures, quickly; keep it for the next one.
class JpegEncoder {
 public:
  /// Fails as `unavailable` where libjpeg-turbo cannot be used.
  static Result<JpegEncoder> create();
  ~JpegEncoder();
  JpegEncoder(JpegEncoder&&) noexcept;
  JpegEncoder& operator=(JpegEncoder&&) noexcept;

  /// `quality` from 1 to 100; full colour resolution where sharp, else a quarter of it.
  Result<std::vector<std::byte>> encode(const Image& picture, int quality, bool sharp);

 private:
  struct State;
  explicit JpegEncoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
