// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture_writer.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace bedmix {

enum class FilmKind {
  mp4,  // H.264, for every player
  gif,  // 255 colours, for pages and slides
  mkv,  // FFV1, every pixel as it was drawn
};

/// By the ending of a file; none for others.
std::optional<FilmKind> filmKindOf(const std::filesystem::path& path);

/// The rate nearest to `fps` that a film of this kind can have. A GIF tells the time in 1/100 s, and players
/// take less than two of them for no time at all.
double fittingRate(FilmKind kind, double fps);

/// The size of a film of this kind that shows such pictures whole.
Size fittingSize(FilmKind kind, Size picture);

/// A film of the kind that the ending of `path` says. Fails as `input` for an ending or a size that no film
/// has, as `unavailable` without the encoder, as `file` where `path` cannot be written.
Result<std::unique_ptr<PictureWriter>> createFilm(const std::filesystem::path& path, Size size, double fps);

}  // namespace bedmix
