// SPDX-License-Identifier: MIT
#include "render/gif_palette.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace bedmix {

namespace {

constexpr int bits = 6;

/// Up to how many colours a new one must be how far from all others, in steps of 1/255.
struct Reach {
  std::size_t colors;
  int distance;
};
constexpr Reach reaches[] = {{128, 6}, {192, 12}, {GifPalette::most, 24}};

int squaredDistance(Rgba a, Rgba b) {
  const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

}  // namespace

GifPalette::GifPalette() : cells_(std::size_t{1} << (3 * bits)) {}

std::size_t GifPalette::cellOf(const std::uint8_t* pixel) {
  constexpr int drop = 8 - bits;
  return static_cast<std::size_t>((pixel[0] >> drop) << (2 * bits) | (pixel[1] >> drop) << bits |
                                  pixel[2] >> drop);
}

void GifPalette::count(const Image& picture) {
  fresh_.clear();
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const std::uint8_t* pixel = &picture.rgba[i];
    Cell& cell = cells_[cellOf(pixel)];
    if (cell.placed) continue;
    if (cell.pixels++ == 0) fresh_.push_back(cellOf(pixel));
    const Rgba color{pixel[0], pixel[1], pixel[2]};
    if (cell.votes == 0) cell.color = color;
    cell.votes += cell.color == color ? 1 : -1;
  }
}

std::uint8_t GifPalette::placeFor(Rgba color) {
  std::size_t nearest = 0;
  int best = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colors_.size(); ++i)
    if (const int distance = squaredDistance(colors_[i], color); distance < best) {
      best = distance;
      nearest = i;
    }
  for (const Reach& reach : reaches)
    if (colors_.size() < reach.colors && best > reach.distance * reach.distance) {
      colors_.push_back(color);
      return static_cast<std::uint8_t>(colors_.size() - 1);
    }
  return static_cast<std::uint8_t>(nearest);
}

void GifPalette::map(const Image& picture, std::uint8_t* places, std::size_t stride) {
  count(picture);
  std::sort(fresh_.begin(), fresh_.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(-cells_[a].pixels, a) < std::tuple(-cells_[b].pixels, b);
  });
  for (const std::size_t index : fresh_) {
    Cell& cell = cells_[index];
    cell.place = placeFor(cell.color);
    cell.placed = true;
  }
  const auto width = static_cast<std::size_t>(picture.size.width);
  const std::uint8_t* pixel = picture.rgba.data();
  for (int y = 0; y < picture.size.height; ++y, places += stride)
    for (std::size_t x = 0; x < width; ++x, pixel += 4) places[x] = cells_[cellOf(pixel)].place;
}

}  // namespace bedmix
