// SPDX-License-Identifier: MIT
#include "render/film_kind.h"

#include "render/gif_film.h"
#include "render/mkv_film.h"
#include "render/mp4_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bedmix {

namespace {

/// Delay of a GIF's pictures, 1/100 s.
double gifDelay(double fps) { return std::max(2.0, std::round(100.0 / fps)); }

/// Pixels of the largest picture.
struct Limit {
  std::int64_t pixels;
  const char* why;
};
constexpr Limit mp4Limit{std::int64_t{139264} * 16 * 16, "H.264 ends at level 6.2, 8192x4352"};
constexpr Limit mkvLimit{std::int64_t{8192} * 8192, "FFV1 is encoded up to 8192x8192"};

Result<Done> fits(const std::filesystem::path& path, Size size, const Limit& limit) {
  if (std::int64_t{size.width} * size.height <= limit.pixels) return Done{};
  return Diagnostic{{path.string()},
                    fmt::format("a film of {}x{} is too large: {}", size.width, size.height, limit.why)};
}

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

Size fittingSize(FilmKind kind, Size picture) { return kind == FilmKind::mp4 ? evenSize(picture) : picture; }

Result<std::unique_ptr<PictureWriter>> createFilm(const std::filesystem::path& path, Size size, double fps) {
  const auto kind = filmKindOf(path);
  if (!kind) return Diagnostic{{path.string()}, "is no kind of film; give a .mp4, a .gif or a .mkv"};
  if (*kind == FilmKind::gif) return hidden(GifFilm::create(path, size, static_cast<int>(gifDelay(fps))));
  const bool lossless = *kind == FilmKind::mkv;
  if (Result<Done> done = fits(path, size, lossless ? mkvLimit : mp4Limit); !done) return done.problems;
  return lossless ? hidden(MkvFilm::create(path, size, fps)) : hidden(Mp4Film::create(path, size, fps));
}

}  // namespace bedmix
