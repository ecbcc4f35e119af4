// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace bedmix {

/// Memory that a process has in common with the children it starts later. It takes no more than has been
/// opened.
class SharedMemory {
 public:
  /// Throws std::system_error where the system has none left.
  explicit SharedMemory(std::size_t most);
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  ~SharedMemory();

  /// Makes the first `size` bytes usable, here and in the children. Throws std::system_error where they are
  /// more than the most, or than the system has.
  void open(std::size_t size);
  std::byte* data() const { return data_; }

 private:
  int descriptor_;
  std::size_t most_;
  std::byte* data_;
};

}  // namespace bedmix
