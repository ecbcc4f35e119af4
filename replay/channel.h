// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace bedmix {

/// The other end has closed.
struct ChannelClosed : std::runtime_error {
  ChannelClosed() : std::runtime_error("the other end has closed") {}
};

/// One end of a connection between two processes of this program: values go as they lie in memory. All calls
/// wait until they are done, and throw ChannelClosed where that cannot be.
class Channel {
 public:
  /// Owns the descriptor of a socket.
  explicit Channel(int descriptor) : descriptor_(descriptor) {}
  Channel(Channel&& other) noexcept;
  Channel& operator=(Channel&& other) noexcept;
  ~Channel();

  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    send(std::as_bytes(std::span(&value, 1)));
  }
  /// How many, then each.
  template <class List>
  void putAll(const List& values) {
    put(static_cast<std::uint64_t>(values.size()));
    send(std::as_bytes(std::span(values.data(), values.size())));
  }

  template <class T>
  T get() {
    T value{};
    receive(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }
  template <class List>
  List getAll() {
    constexpr std::size_t atOnce = 1 << 20;  // memory is taken for what comes, not for what was announced
    List values;
    for (auto left = get<std::uint64_t>(); left > 0;) {
      const std::size_t before = values.size(), more = std::min<std::uint64_t>(left, atOnce);
      values.resize(before + more);
      receive(std::as_writable_bytes(std::span(values.data() + before, more)));
      left -= more;
    }
    return values;
  }

 private:
  void send(std::span<const std::byte> bytes);
  void receive(std::span<std::byte> bytes);

  int descriptor_;
};

}  // namespace bedmix
