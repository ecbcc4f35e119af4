// SPDX-License-Identifier: MIT
#include "render/mkv_film.h"

#include "engine/core/thread_team.h"
#include "render/av_film.h"

#include <algorithm>

namespace bedmix {

namespace {

/// Part of the stream, so they do not follow the machine; the threads that share them do. As many as the
/// largest film needs.
constexpr int slices = 16;
constexpr int version = 3;  // of FFV1, the one with a checksum for each slice
constexpr AvFormat mkvFormat{"ffv1", "matroska", "cluster_time_limit=1000"};  // ms; what a kill may cost

void setEncoder(AVCodecContext& encoder) {
  encoder.pix_fmt = AV_PIX_FMT_0RGB32;
  encoder.color_primaries = AVCOL_PRI_BT709;
  encoder.color_trc = AVCOL_TRC_IEC61966_2_1;  // sRGB
  encoder.colorspace = AVCOL_SPC_RGB;
  encoder.color_range = AVCOL_RANGE_JPEG;
  encoder.gop_size = 1;
  encoder.level = version;
  encoder.slices = slices;
  encoder.thread_count = std::min(slices, availableCores());
  encoder.thread_type = FF_THREAD_SLICE;
}

}  // namespace

struct MkvFilm::State {
  AvFilm film;
};

MkvFilm::MkvFilm(std::unique_ptr<State> state) : state_(std::move(state)) {}
MkvFilm::~MkvFilm() = default;
MkvFilm::MkvFilm(MkvFilm&&) noexcept = default;
MkvFilm& MkvFilm::operator=(MkvFilm&&) noexcept = default;

Result<MkvFilm> MkvFilm::create(const std::filesystem::path& path, Size size, double fps) {
  std::unique_ptr<State> state(new State{{path, mkvFormat}});
  if (Result<Done> done = state->film.findEncoder(size, av_d2q(fps, 1001000)); !done) return done.problems;
  setEncoder(state->film.encoder());
  if (Result<Done> done = state->film.open(); !done) return done.problems;
  return MkvFilm(std::move(state));
}

Result<Done> MkvFilm::add(const Image& picture) {
  AvFilm& film = state_->film;
  if (Result<Done> done = film.takeFrame(); !done) return done;
  const std::size_t width = picture.size.width;
  for (int y = 0; y < picture.size.height; ++y) {
    const std::uint8_t* from = picture.rgba.data() + 4 * width * y;
    auto* to = reinterpret_cast<std::uint32_t*>(film.frame().data[0] + y * film.frame().linesize[0]);
    for (std::size_t x = 0; x < width; ++x, from += 4)
      to[x] = std::uint32_t{from[0]} << 16 | std::uint32_t{from[1]} << 8 | std::uint32_t{from[2]};
  }
  return film.encode();
}

Result<Done> MkvFilm::finish() {
  if (Result<Done> done = state_->film.close(); !done) return done;
  return state_->film.part().keep();
}

}  // namespace bedmix
