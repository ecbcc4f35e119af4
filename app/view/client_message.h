// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/panel/input_event.h"

#include <cstdint>
#include <string_view>
#include <variant>

namespace bedmix {

/// How pictures may come to a client.
enum class PictureCodec { jpeg, h264 };

/// The first message of a client: what it can show.
struct Hello {
  PictureCodec codec = PictureCodec::jpeg;
};
/// It has shown the picture, so that another may be on its way.
struct Acknowledgement {
  std::uint32_t picture = 0;
};
/// An input, numbered by the page so that it can tell which picture shows what came of it.
struct NumberedInput {
  std::uint32_t number = 0;
  InputEvent event;
};
/// It asks to be the one whose input counts; only with the token for that.
struct ControlRequest {};

using ClientMessage = std::variant<Hello, Acknowledgement, NumberedInput, ControlRequest>;

/// Longest message of a client that is read, bytes.
inline constexpr std::size_t longestClientMessage = 4096;

/// Reads a message as the page writes it: one JSON object, see assets/docs/view.md. Anything else, a number
/// that is not finite, a size beyond what pictures may have, is a Diagnostic.
Result<ClientMessage> parseClientMessage(std::string_view json);

}  // namespace bedmix
