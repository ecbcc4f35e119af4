// SPDX-License-Identifier: MIT
#pragma once

#include "render/image.h"

#include <memory>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/frame.h>
}

struct SwsContext;

namespace bedmix {

/// From a picture to the planes H.264 is made of: 4:2:0, BT.709, limited range. Even sizes: a picture that is
/// not repeats its last pixels.
class YuvPicture {
 public:
  enum class Quality { quick, exact };

  YuvPicture(Size picture, Quality quality);

  /// Of the planes.
  Size size() const { return padded_.size; }
  /// Into a frame of that size, which must be ours to write.
  void convert(const Image& picture, AVFrame& into);

 private:
  struct FreeScaler {
    void operator()(SwsContext* scaler) const;
  };
  Size picture_;
  Image padded_;  // unused where the picture is even
  std::unique_ptr<SwsContext, FreeScaler> scaler_;
};

/// Says so in the stream.
void setBt709(AVCodecContext& encoder);

}  // namespace bedmix
