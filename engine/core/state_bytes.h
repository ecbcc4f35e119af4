// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

// The state of a run as bytes: every part of the engine that a run cannot go on without has
// save(StateWriter&) and load(StateReader&), which take the same values in the same order. Values are whole
// numbers or made of doubles alone, as they lie in memory.

namespace bedmix {

class StateWriter {
 public:
  /// Room for so many bytes; memory that is not written to costs nothing.
  explicit StateWriter(std::size_t expected) { bytes_.reserve(expected); }

  template <class T>
  void put(const T& value) {
    append(std::as_bytes(std::span(&value, 1)));
  }
  /// How many, then each.
  template <class T>
  void putAll(std::span<const T> values) {
    put(static_cast<std::uint64_t>(values.size()));
    append(std::as_bytes(values));
  }
  template <class T>
  void putAll(const std::vector<T>& values) {
    putAll(std::span(values));
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void append(std::span<const std::byte> more) { bytes_.insert(bytes_.end(), more.begin(), more.end()); }

  std::vector<std::byte> bytes_;
};

/// Reads it back from bytes that may be anything. What it fills must have its size already, which follows
/// from the scene: nothing is ever allocated because the bytes say so. All return false where the bytes end,
/// hold another number of values, or a double that is not finite or so large that a frame, which holds
/// floats, might not hold it some steps later; then the rest means nothing.
class StateReader {
 public:
  explicit StateReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  [[nodiscard]] bool get(T& value) {
    return take(std::span(&value, 1));
  }
  template <class T>
  [[nodiscard]] bool getAll(std::span<T> values) {
    std::uint64_t size = 0;
    return get(size) && size == values.size() && take(values);
  }
  template <class T>
  [[nodiscard]] bool getAll(std::vector<T>& values) {
    return getAll(std::span(values));
  }
  /// Whether all has been read.
  bool done() const { return rest_.empty(); }

 private:
  template <class T>
  bool take(std::span<T> values) {
    if (values.empty()) return true;
    if (rest_.size() < values.size_bytes()) return false;
    std::memcpy(values.data(), rest_.data(), values.size_bytes());
    rest_ = rest_.subspan(values.size_bytes());
    if constexpr (!std::is_integral_v<T>) {
      constexpr double most = 1e30;
      static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
      const auto* numbers = reinterpret_cast<const double*>(values.data());
      for (std::size_t i = 0; i < values.size_bytes() / sizeof(double); ++i)
        if (!(std::abs(numbers[i]) <= most)) return false;
    }
    return true;
  }

  std::span<const std::byte> rest_;
};

}  // namespace bedmix
