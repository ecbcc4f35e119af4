// SPDX-License-Identifier: MIT
#include "render/colors.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr int steps = 256;
using Map = std::array<Rgba, steps>;

std::uint8_t toByte(double channel) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0, 255.0)));
}

/// Highest power first.
std::uint8_t polynomial(const std::array<double, 6>& coefficients, double t) {
  double sum = 0.0;
  for (const double c : coefficients) sum = sum * t + c;
  return toByte(sum);
}

Map makeCividis() {
  Map map;
  for (int i = 0; i < steps; ++i) {
    const double t = i / (steps - 1.0);
    map[i] = {polynomial({-2710.57, 7024.72, -6402.7, 2381.73, -35.34, -4.54}, t),
              polynomial({-67.37, 176.58, -131.46, 52.82, 170.73, 32.49}, t),
              polynomial({2475.67, -6614.94, 6167.24, -2482.43, 442.36, 81.24}, t)};
  }
  return map;
}

/// sRGB of a colour in CIE Lab under D65.
Rgba fromLab(double l, double a, double b) {
  const auto cubed = [](double t) { return t > 6.0 / 29.0 ? t * t * t : (t - 4.0 / 29.0) * 108.0 / 841.0; };
  const double fy = (l + 16.0) / 116.0;
  const double x = 0.95047 * cubed(fy + a / 500.0), y = cubed(fy), z = 1.08883 * cubed(fy - b / 200.0);
  const auto channel = [](double v) {
    return toByte(255.0 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055));
  };
  return {channel(3.2406 * x - 1.5372 * y - 0.4986 * z), channel(-0.9689 * x + 1.8758 * y + 0.0415 * z),
          channel(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

/// In polar Lab coordinates (magnitude, saturation, hue) saturation falls evenly to none and grows again.
Map makeCoolWarm() {
  constexpr double magnitude = 80.0, saturation = 1.08, cool = -1.1, warm = 0.5;
  Map map;
  for (int i = 0; i < steps; ++i) {
    const double t = 2.0 * i / (steps - 1.0) - 1.0;
    const double s = saturation * std::abs(t), hue = t < 0.0 ? cool : warm;
    map[i] = fromLab(magnitude * std::cos(s), magnitude * std::sin(s) * std::cos(hue),
                     magnitude * std::sin(s) * std::sin(hue));
  }
  return map;
}

Rgba lookUp(const Map& map, double t) {
  return map[static_cast<std::size_t>(std::clamp(t, 0.0, 1.0) * (steps - 1) + 0.5)];
}

/// Relative luminance of sRGB, 0 to 1.
double luminance(Rgba color) {
  const auto linear = [](std::uint8_t c) {
    const double v = c / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

}  // namespace

Palette paletteOn(Rgba ground) {
  // Contrast is (lighter + 0.05) / (darker + 0.05): equal to black and white where its square is 21.
  if (std::pow((luminance(ground) + 0.05) / 0.05, 2) >= 21.0) {
    Palette light;
    light.ground = ground;
    return light;
  }
  return {.ground = ground,
          .ink = white,
          .grid = {80, 80, 80},
          .tracer = white,
          .sampling = {70, 115, 160},
          .gas = {120, 200, 255},
          .wall = {190, 190, 190},
          .distributor = {90, 90, 90},
          .lowest = 0.2,
          .highest = 1.0};
}

Rgba cividis(double t) {
  static const Map map = makeCividis();
  return lookUp(map, t);
}

Rgba coolWarm(double t) {
  static const Map map = makeCoolWarm();
  return lookUp(map, 0.5 * t + 0.5);
}

}  // namespace bedmix
