// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace bedmix {

/// H.264 for a person who waits for it: each picture comes out as soon as it went in, constrained baseline in
/// Annex B, for a browser's decoder. Not for files; see FilmSink.
class H264Stream {
 public:
  /// Pictures of `size`, at most `fps` a second. Fails as `unavailable` without the encoder.
  static Result<H264Stream> create(Size size, double fps);
  ~H264Stream();
  H264Stream(H264Stream&&) noexcept;
  H264Stream& operator=(H264Stream&&) noexcept;

  struct Packet {
    std::vector<std::byte> bytes;
    bool isKey = false;  // a decoder can begin with it
  };
  /// The first is a key picture, and one that is asked for.
  Result<Packet> encode(const Image& picture, bool key = false);

 private:
  struct State;
  explicit H264Stream(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
