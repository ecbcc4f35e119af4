// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>

namespace bedmix {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Closed interval; `aboveMin` excludes its lower end.
struct KeyRange {
  double min = -infinity;
  double max = infinity;
  bool aboveMin = false;
};
inline constexpr KeyRange positive{0.0, infinity, true};
inline constexpr KeyRange notNegative{0.0, infinity};

struct Key {
  std::string_view name;
  std::string_view unit;  // "" for a number without one, a text or a table
  KeyRange range;
  std::string_view meaning;
  bool required = false;
};

}  // namespace bedmix
