// SPDX-License-Identifier: MIT
#include "app/view/client_message.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

namespace {

using Json = nlohmann::json;

constexpr double furthest = 65536.0;          // px, of a pointer, and notches of a wheel
constexpr int smallest = 16, largest = 4096;  // px, a side of the picture
constexpr double smallestScale = 0.5, largestScale = 4.0;
constexpr std::size_t longestText = 64;  // bytes

/// What is wrong with a message, on its way to the caller.
struct Refusal {
  std::string why;
};

const Json& member(const Json& message, const char* name) {
  const auto found = message.find(name);
  if (found == message.end()) throw Refusal{fmt::format("{} is missing", name)};
  return *found;
}

double number(const Json& message, const char* name, double low, double high) {
  const Json& value = member(message, name);
  if (!value.is_number()) throw Refusal{fmt::format("{} must be a number", name)};
  const double x = value.get<double>();
  if (!(x >= low && x <= high)) throw Refusal{fmt::format("{} must be from {} to {}", name, low, high)};
  return x;
}

std::uint32_t whole(const Json& message, const char* name, std::uint32_t most) {
  const Json& value = member(message, name);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
    throw Refusal{fmt::format("{} must be a whole number from 0 to {}", name, most)};
  return value.get<std::uint32_t>();
}

bool truth(const Json& message, const char* name) {
  const Json& value = member(message, name);
  if (!value.is_boolean()) throw Refusal{fmt::format("{} must be true or false", name)};
  return value.get<bool>();
}

std::string text(const Json& message, const char* name) {
  const Json& value = member(message, name);
  if (!value.is_string()) throw Refusal{fmt::format("{} must be a text", name)};
  return value.get<std::string>();
}

Vec2f pair(const Json& message, const char* x, const char* y) {
  return {static_cast<float>(number(message, x, -furthest, furthest)),
          static_cast<float>(number(message, y, -furthest, furthest))};
}

/// Typed by a person: without control characters. The parser has seen to it that it is UTF-8.
std::string typed(const Json& message) {
  std::string value = text(message, "text");
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (value.size() > longestText || std::any_of(value.begin(), value.end(), isControl))
    throw Refusal{fmt::format("text must have at most {} bytes and no control characters", longestText)};
  return value;
}

PanelKey key(const Json& message) {
  const std::string name = text(message, "key");
  const auto known = std::find(panelKeyNames.begin(), panelKeyNames.end(), name);
  if (known == panelKeyNames.end()) throw Refusal{"key is none that is known"};
  return static_cast<PanelKey>(known - panelKeyNames.begin());
}

InputEvent inputEvent(const std::string& type, const Json& message) {
  InputEvent event;
  if (type == "pointer") {
    event.at = pair(message, "x", "y");
    event.buttons = whole(message, "buttons", 7);
    event.isTouch = truth(message, "touch");
  } else if (type == "wheel") {
    event.kind = InputEvent::Kind::wheel;
    event.at = pair(message, "x", "y");
    event.turn = pair(message, "right", "up");
  } else if (type == "key") {
    event.kind = InputEvent::Kind::key;
    event.key = key(message);
    event.isDown = truth(message, "down");
  } else if (type == "text") {
    event.kind = InputEvent::Kind::text;
    event.text = typed(message);
  } else if (type == "size") {
    event.kind = InputEvent::Kind::size;
    event.size = {static_cast<int>(number(message, "width", smallest, largest)),
                  static_cast<int>(number(message, "height", smallest, largest))};
    event.scale = static_cast<float>(number(message, "scale", smallestScale, largestScale));
  } else if (type == "leave") {
    event.kind = InputEvent::Kind::leave;
  } else {
    throw Refusal{"type is none that is known"};
  }
  return event;
}

ClientMessage messageOf(const Json& message) {
  if (!message.is_object()) throw Refusal{"it is no object"};
  const std::string type = text(message, "type");
  if (type == "hello") {
    const std::string codec = text(message, "codec");
    if (codec != "jpeg" && codec != "h264") throw Refusal{"codec must be jpeg or h264"};
    return Hello{codec == "h264" ? PictureCodec::h264 : PictureCodec::jpeg};
  }
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  if (type == "ack") return Acknowledgement{whole(message, "picture", most)};
  if (type == "control") return ControlRequest{};
  return NumberedInput{whole(message, "n", most), inputEvent(type, message)};
}

}  // namespace

Result<ClientMessage> parseClientMessage(std::string_view json) {
  const auto refuse = [](const std::string& why) {
    return Diagnostic{{}, "a message of the page makes no sense: " + why};
  };
  if (json.size() > longestClientMessage) return refuse("it is too long");
  const Json message = Json::parse(json.begin(), json.end(), nullptr, false);
  if (message.is_discarded()) return refuse("it is no JSON");
  try {
    return messageOf(message);
  } catch (const Refusal& refusal) {
    return refuse(refusal.why);
  }
}

}  // namespace bedmix
