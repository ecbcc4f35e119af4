// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace bedmix {

/// The plane of motion: x to the right, y up. Beds are one particle thick, so two components are enough; this
/// file, the bilinear stencil and the cell binning are the places to change if that ever ends.
template <class T>
struct Vec2T {
  T x{}, y{};

  constexpr Vec2T& operator+=(Vec2T o) { return x += o.x, y += o.y, *this; }
  constexpr Vec2T& operator-=(Vec2T o) { return x -= o.x, y -= o.y, *this; }
  constexpr Vec2T& operator*=(T s) { return x *= s, y *= s, *this; }
  friend constexpr Vec2T operator+(Vec2T a, Vec2T b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2T operator-(Vec2T a, Vec2T b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2T operator*(T s, Vec2T a) { return {s * a.x, s * a.y}; }
  friend constexpr Vec2T operator*(Vec2T a, T s) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vec2T, Vec2T) = default;
};

using Vec2 = Vec2T<double>;
using Vec2f = Vec2T<float>;

template <class T>
constexpr T dot(Vec2T<T> a, Vec2T<T> b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
T norm(Vec2T<T> a) {
  return std::sqrt(dot(a, a));
}
constexpr Vec2f toFloat(Vec2 a) { return {static_cast<float>(a.x), static_cast<float>(a.y)}; }
constexpr Vec2 toDouble(Vec2f a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }

}  // namespace bedmix
