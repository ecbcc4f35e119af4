// SPDX-License-Identifier: MIT
#pragma once

#include "render/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The colours of a GIF, found while its pictures come. What has a place once keeps it, so nothing flickers
/// and what rests in the bed rests in the file. Each picture's most frequent new colours come first and are
/// exact; a colour near one that is there takes its place, and the nearer the palette is to full, the farther
/// "near" reaches. The same pictures give the same colours.
class GifPalette {
 public:
  static constexpr std::size_t most = 255;  // the last of 256 is left for "as in the picture before"

  GifPalette();

  /// Writes the place of each pixel's colour, row by row, `stride` bytes from row to row.
  void map(const Image& picture, std::uint8_t* places, std::size_t stride);
  const std::vector<Rgba>& colors() const { return colors_; }

 private:
  /// Colours that are told apart no further: those that share six bits a channel.
  struct Cell {
    bool placed = false;
    std::uint8_t place = 0;
    Rgba color;               // the one that most of its pixels have, where more than half agree
    std::int32_t votes = 0;   // for it, less those against
    std::int32_t pixels = 0;  // in this picture
  };

  static std::size_t cellOf(const std::uint8_t* pixel);
  void count(const Image& picture);
  std::uint8_t placeFor(Rgba color);

  std::vector<Cell> cells_;
  std::vector<std::size_t> fresh_;  // cells of this picture that have no place yet
  std::vector<Rgba> colors_;
};

}  // namespace bedmix
