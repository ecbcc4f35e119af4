// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace bedmix {

/// FNV-1a over the bits of doubles, or over bytes: any single byte that differs gives another value.
class StateHash {
 public:
  void add(std::uint64_t bits) {
    for (int shift = 0; shift < 64; shift += 8) h_ = (h_ ^ ((bits >> shift) & 0xff)) * 1099511628211ull;
  }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
  void add(std::span<const double> values) {
    for (double v : values) add(v);
  }
  void add(std::span<const std::byte> bytes) {
    for (std::byte b : bytes) h_ = (h_ ^ std::to_integer<std::uint64_t>(b)) * 1099511628211ull;
  }
  std::uint64_t value() const { return h_; }

 private:
  std::uint64_t h_ = 14695981039346656037ull;
};

}  // namespace bedmix
