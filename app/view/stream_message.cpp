// SPDX-License-Identifier: MIT
#include "app/view/stream_message.h"

#include <cstring>

namespace bedmix {

namespace {

template <class T>
void put(std::byte* at, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i) at[i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
}

}  // namespace

std::vector<std::byte> streamMessage(const StreamHeader& header, std::span<const std::byte> content) {
  std::vector<std::byte> message(streamHeaderBytes + content.size());
  message[0] = static_cast<std::byte>(header.kind);
  message[1] = static_cast<std::byte>(header.isSharp);
  put(&message[4], header.picture);
  put(&message[8], header.input);
  put(&message[12], header.width);
  put(&message[14], header.height);
  if (!content.empty()) std::memcpy(&message[streamHeaderBytes], content.data(), content.size());
  return message;
}

std::vector<std::byte> noticeMessage(std::string_view json) {
  return streamMessage({.kind = StreamKind::notice}, std::as_bytes(std::span(json.data(), json.size())));
}

}  // namespace bedmix
