// SPDX-License-Identifier: MIT
#include "engine/core/color.h"

#include <fmt/format.h>

#include <charconv>

namespace bedmix {

std::optional<Rgba> parseColor(std::string_view text) {
  if (text == "white") return white;
  if (text == "black") return black;
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift); };
  return Rgba{byte(16), byte(8), byte(0)};
}

std::string colorText(Rgba color) {
  if (color == white) return "white";
  if (color == black) return "black";
  return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

}  // namespace bedmix
