// SPDX-License-Identifier: MIT
#include "render/film_kind.h"

#include "render/gif_film.h"
#include "render/mkv_film.h"
#include "render/mp4_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Delay of a GIF's pictures, 1/100 s.
double gifDelay(double fps) { return std::max(2.0, std::round(100.0 / fps)); }

template <class Film>
Result<std::unique_ptr<PictureWriter>> hidden(Result<Film> film) {
  if (!film) return film.problems;
  return std::unique_ptr<PictureWriter>(std::make_unique<Film>(std::move(*film)));
}

}  // namespace

std::optional<FilmKind> filmKindOf(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".mp4") return FilmKind::mp4;
  if (ending == ".gif") return FilmKind::gif;
  if (ending == ".mkv") return FilmKind::mkv;
  return std::nullopt;
}

double fittingRate(FilmKind kind, double fps) { return kind == FilmKind::gif ? 100.0 / gifDelay(fps) : fps; }

Result<std::unique_ptr<PictureWriter>> createFilm(const std::filesystem::path& path, Size size, double fps) {
  const auto kind = filmKindOf(path);
  if (!kind) return Diagnostic{{path.string()}, "is no kind of film; give a .mp4, a .gif or a .mkv"};
  switch (*kind) {
    case FilmKind::gif:
      return hidden(GifFilm::create(path, size, static_cast<int>(gifDelay(fps))));
    case FilmKind::mkv:
      return hidden(MkvFilm::create(path, size, fps));
    case FilmKind::mp4:
      break;
  }
  return hidden(Mp4Film::create(path, size, fps));
}

}  // namespace bedmix
