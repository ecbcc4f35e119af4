// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace bedmix {

/// What a binary message to the page brings.
enum class StreamKind : std::uint8_t {
  jpeg = 1,      // a picture by itself
  h264Key = 2,   // a picture that a decoder can begin with, Annex B
  h264Next = 3,  // one that follows the one before
  notice = 4,  // JSON, UTF-8: {"role": "controller" | "viewer", "mayControl": true}, {"cursor": "ew-resize"},
               // {"keyboard": true}: a text is being edited, {"saved": "/saved/NAME"},
               // {"ended": "why"}
};

/// The header before it: 16 bytes, little-endian.
///   0  kind          uint8
///   1  sharp         uint8, 1 for a still picture in full quality
///   2  reserved      uint16, 0
///   4  picture       uint32, number to acknowledge; 0 for a notice, which is not acknowledged
///   8  input         uint32, the last input whose effect is in the picture
///  12  width, height uint16 each, px
struct StreamHeader {
  StreamKind kind = StreamKind::jpeg;
  bool isSharp = false;
  std::uint32_t picture = 0, input = 0;
  std::uint16_t width = 0, height = 0;
};
inline constexpr std::size_t streamHeaderBytes = 16;

std::vector<std::byte> streamMessage(const StreamHeader& header, std::span<const std::byte> content);
/// A notice, of JSON.
std::vector<std::byte> noticeMessage(std::string_view json);

}  // namespace bedmix
