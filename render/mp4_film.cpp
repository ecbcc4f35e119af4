// SPDX-License-Identifier: MIT
#include "render/mp4_film.h"

#include "render/av_film.h"
#include "render/mp4_remux.h"

#include <algorithm>
#include <cmath>

extern "C" {
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace bedmix {

namespace {

constexpr const char* encoderName = "libx264";
/// The stream depends on it, so it does not follow the machine.
constexpr int encoderThreads = 2;
constexpr AvFormat format{encoderName, "mp4", "movflags=frag_keyframe+empty_moov+default_base_moof"};

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

struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

}  // namespace

struct Mp4Film::State {
  std::filesystem::path target;
  Size picture;
  Image padded;  // of the film's size; unused where that is the picture's
  AvFilm film;
  std::unique_ptr<SwsContext, FreeScaler> toYuv;

  State(const std::filesystem::path& path, Size size) : target(path), picture(size), film(path, format) {
    padded.resize(evenSize(size));
  }
  void setEncoder(double fps);
  void setConversion();
};

void Mp4Film::State::setEncoder(double fps) {
  AVCodecContext& encoder = film.encoder();
  encoder.pix_fmt = AV_PIX_FMT_YUV420P;
  encoder.color_primaries = AVCOL_PRI_BT709;
  encoder.color_trc = AVCOL_TRC_BT709;
  encoder.colorspace = AVCOL_SPC_BT709;
  encoder.color_range = AVCOL_RANGE_MPEG;
  encoder.gop_size = std::max(1, static_cast<int>(std::lround(fps)));  // a fragment a second
  encoder.max_b_frames = 0;                                            // starts at 0 in every player
  encoder.thread_count = encoderThreads;
  av_opt_set(encoder.priv_data, "preset", "veryfast", 0);
  av_opt_set(encoder.priv_data, "crf", "18", 0);
}

void Mp4Film::State::setConversion() {
  const Size size = padded.size;
  toYuv.reset(sws_getContext(
      size.width, size.height, AV_PIX_FMT_RGBA, size.width, size.height, AV_PIX_FMT_YUV420P,
      SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT, nullptr, nullptr, nullptr));
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(toYuv.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
}

Mp4Film::Mp4Film(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mp4Film::~Mp4Film() = default;
Mp4Film::Mp4Film(Mp4Film&&) noexcept = default;
Mp4Film& Mp4Film::operator=(Mp4Film&&) noexcept = default;

Result<Mp4Film> Mp4Film::create(const std::filesystem::path& path, Size size, double fps) {
  auto state = std::make_unique<State>(path, size);
  if (Result<Done> done = state->film.findEncoder(state->padded.size, av_d2q(fps, 1001000)); !done)
    return done.problems;
  state->setEncoder(fps);
  if (Result<Done> done = state->film.open(); !done) return done.problems;
  state->setConversion();
  return Mp4Film(std::move(state));
}

Result<Done> Mp4Film::add(const Image& picture) {
  State& s = *state_;
  const bool even = s.picture == s.padded.size;
  if (!even) pad(picture, s.padded);
  if (Result<Done> done = s.film.takeFrame(); !done) return done;
  const std::uint8_t* pixels[] = {(even ? picture : s.padded).rgba.data()};
  const int stride[] = {4 * s.padded.size.width};
  AVFrame& frame = s.film.frame();
  sws_scale(s.toYuv.get(), pixels, stride, 0, s.padded.size.height, frame.data, frame.linesize);
  return s.film.encode();
}

Result<Done> Mp4Film::finish() {
  if (Result<Done> done = state_->film.close(); !done) return done;
  return remuxMp4(state_->film.part().path(), state_->target);
}

Size evenSize(Size picture) {
  return {picture.width + picture.width % 2, picture.height + picture.height % 2};
}

Result<std::string> probeEncoder() { return probeAvEncoder(encoderName); }

}  // namespace bedmix
