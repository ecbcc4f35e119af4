// SPDX-License-Identifier: MIT
#include "render/gif_film.h"

#include "render/av_film.h"
#include "render/gif_palette.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr AvFormat gifFormat{"gif", "gif", ""};
constexpr std::uint32_t opaque = 0xff000000;

}  // namespace

struct GifFilm::State {
  AvFilm film;
  GifPalette palette;

  explicit State(const std::filesystem::path& path) : film(path, gifFormat) {}
};

GifFilm::GifFilm(std::unique_ptr<State> state) : state_(std::move(state)) {}
GifFilm::~GifFilm() = default;
GifFilm::GifFilm(GifFilm&&) noexcept = default;
GifFilm& GifFilm::operator=(GifFilm&&) noexcept = default;

Result<GifFilm> GifFilm::create(const std::filesystem::path& path, Size size, int delay) {
  auto state = std::make_unique<State>(path);
  AvFilm& film = state->film;
  if (Result<Done> done = film.findEncoder(size, {100, delay}); !done) return done.problems;
  film.encoder().pix_fmt = AV_PIX_FMT_PAL8;
  film.encoder().thread_count = 1;
  if (Result<Done> done = film.open(); !done) return done.problems;
  return GifFilm(std::move(state));
}

Result<Done> GifFilm::add(const Image& picture) {
  AvFilm& film = state_->film;
  if (Result<Done> done = film.takeFrame(); !done) return done;
  AVFrame& frame = film.frame();
  state_->palette.map(picture, frame.data[0], frame.linesize[0]);
  auto* colors = reinterpret_cast<std::uint32_t*>(frame.data[1]);
  std::fill_n(colors, GifPalette::most, opaque);
  colors[GifPalette::most] = 0;  // transparent: what the encoder makes of pixels that stay as they are
  for (const Rgba c : state_->palette.colors())
    *colors++ = opaque | std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
  return film.encode();
}

Result<Done> GifFilm::finish() {
  if (Result<Done> done = state_->film.close(); !done) return done;
  return state_->film.part().keep();
}

}  // namespace bedmix
