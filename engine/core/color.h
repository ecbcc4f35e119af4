// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bedmix {

struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(Rgba, Rgba) = default;
};

inline constexpr Rgba white{255, 255, 255};
inline constexpr Rgba black{0, 0, 0};

/// Reads "white", "black" or "#rrggbb".
std::optional<Rgba> parseColor(std::string_view text);
/// The same the other way round.
std::string colorText(Rgba color);

}  // namespace bedmix
