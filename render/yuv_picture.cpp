// SPDX-License-Identifier: MIT
#include "render/yuv_picture.h"

#include "render/mp4_film.h"

#include <algorithm>

extern "C" {
#include <libswscale/swscale.h>
}

namespace bedmix {

namespace {

/// Repeats the last pixel of each row and the last row, where the film is larger than the picture.
void pad(const Image& picture, Image& padded) {
  const std::size_t from = 4 * static_cast<std::size_t>(picture.size.width);
  const std::size_t to = 4 * static_cast<std::size_t>(padded.size.width);
  for (int y = 0; y < padded.size.height; ++y) {
    const std::uint8_t* row = picture.rgba.data() + std::min(y, picture.size.height - 1) * from;
    std::uint8_t* out = padded.rgba.data() + y * to;
    std::copy_n(row, from, out);
    if (to > from) std::copy_n(row + from - 4, 4, out + from);
  }
}

}  // namespace

void YuvPicture::FreeScaler::operator()(SwsContext* scaler) const { sws_freeContext(scaler); }

YuvPicture::YuvPicture(Size picture, Quality quality) : picture_(picture) {
  padded_.resize(evenSize(picture));
  const int flags = quality == Quality::quick
                        ? SWS_POINT
                        : SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT;
  const auto [width, height] = padded_.size;
  scaler_.reset(sws_getContext(width, height, AV_PIX_FMT_RGBA, width, height, AV_PIX_FMT_YUV420P, flags,
                               nullptr, nullptr, nullptr));
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler_.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
}

void YuvPicture::convert(const Image& picture, AVFrame& into) {
  const bool even = picture_ == padded_.size;
  if (!even) pad(picture, padded_);
  const std::uint8_t* pixels[] = {(even ? picture : padded_).rgba.data()};
  const int stride[] = {4 * padded_.size.width};
  sws_scale(scaler_.get(), pixels, stride, 0, padded_.size.height, into.data, into.linesize);
}

void setBt709(AVCodecContext& encoder) {
  encoder.pix_fmt = AV_PIX_FMT_YUV420P;
  encoder.color_primaries = AVCOL_PRI_BT709;
  encoder.color_trc = AVCOL_TRC_BT709;
  encoder.colorspace = AVCOL_SPC_BT709;
  encoder.color_range = AVCOL_RANGE_MPEG;
}

}  // namespace bedmix
