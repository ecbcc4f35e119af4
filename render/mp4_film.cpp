// SPDX-License-Identifier: MIT
#include "render/mp4_film.h"

#include "render/av_film.h"
#include "render/mp4_remux.h"
#include "render/yuv_picture.h"

#include <algorithm>
#include <cmath>

extern "C" {
#include <libavutil/opt.h>
}

namespace bedmix {

namespace {

constexpr const char* encoderName = "libx264";
/// The stream depends on it, so it does not follow the machine.
constexpr int encoderThreads = 2;
constexpr AvFormat mp4Format{encoderName, "mp4", "movflags=frag_keyframe+empty_moov+default_base_moof"};

}  // namespace

struct Mp4Film::State {
  std::filesystem::path target;
  AvFilm film;
  YuvPicture toYuv;

  State(const std::filesystem::path& path, Size size)
      : target(path), film(path, mp4Format), toYuv(size, YuvPicture::Quality::exact) {}
  void setEncoder(double fps);
};

void Mp4Film::State::setEncoder(double fps) {
  AVCodecContext& encoder = film.encoder();
  setBt709(encoder);
  encoder.gop_size = std::max(1, static_cast<int>(std::lround(fps)));  // a fragment a second
  encoder.max_b_frames = 0;                                            // starts at 0 in every player
  encoder.thread_count = encoderThreads;
  av_opt_set(encoder.priv_data, "preset", "veryfast", 0);
  av_opt_set(encoder.priv_data, "crf", "18", 0);
}

Mp4Film::Mp4Film(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mp4Film::~Mp4Film() = default;
Mp4Film::Mp4Film(Mp4Film&&) noexcept = default;
Mp4Film& Mp4Film::operator=(Mp4Film&&) noexcept = default;

Result<Mp4Film> Mp4Film::create(const std::filesystem::path& path, Size size, double fps) {
  auto state = std::make_unique<State>(path, size);
  if (Result<Done> done = state->film.findEncoder(state->toYuv.size(), av_d2q(fps, 1001000)); !done)
    return done.problems;
  state->setEncoder(fps);
  if (Result<Done> done = state->film.open(); !done) return done.problems;
  return Mp4Film(std::move(state));
}

Result<Done> Mp4Film::add(const Image& picture) {
  State& s = *state_;
  if (Result<Done> done = s.film.takeFrame(); !done) return done;
  s.toYuv.convert(picture, s.film.frame());
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
