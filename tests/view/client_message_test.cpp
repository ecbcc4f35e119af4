// SPDX-License-Identifier: MIT
#include "app/view/client_message.h"

#include "app/view/stream_message.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

InputEvent input(const std::string& json, std::uint32_t number) {
  const auto message = parseClientMessage(json);
  EXPECT_TRUE(message) << json;
  const auto* numbered = message ? std::get_if<NumberedInput>(&*message) : nullptr;
  EXPECT_TRUE(numbered) << json;
  if (!numbered) return {};
  EXPECT_EQ(numbered->number, number);
  return numbered->event;
}

TEST(ClientMessage, EachKindIsRead) {
  EXPECT_EQ(std::get<Hello>(*parseClientMessage(R"({"type":"hello","codec":"h264"})")).codec,
            PictureCodec::h264);
  EXPECT_EQ(std::get<Hello>(*parseClientMessage(R"({"type":"hello","codec":"jpeg"})")).codec,
            PictureCodec::jpeg);
  EXPECT_EQ(std::get<Acknowledgement>(*parseClientMessage(R"({"type":"ack","picture":4294967295})")).picture,
            4294967295u);
  EXPECT_TRUE(std::holds_alternative<ControlRequest>(*parseClientMessage(R"({"type":"control"})")));

  EXPECT_EQ(input(R"({"type":"pointer","n":3,"x":1.5,"y":-2,"buttons":5,"touch":true})", 3),
            (InputEvent{.at = {1.5f, -2.0f}, .buttons = 5, .isTouch = true}));
  EXPECT_EQ(input(R"({"type":"wheel","n":4,"x":1,"y":2,"right":0,"up":-1})", 4),
            (InputEvent{.kind = InputEvent::Kind::wheel, .at = {1.0f, 2.0f}, .turn = {0.0f, -1.0f}}));
  EXPECT_EQ(input(R"({"type":"key","n":5,"key":"Enter","down":true})", 5),
            (InputEvent{.kind = InputEvent::Kind::key, .key = PanelKey::enter, .isDown = true}));
  EXPECT_EQ(input(R"({"type":"text","n":6,"text":"ä2"})", 6),
            (InputEvent{.kind = InputEvent::Kind::text, .text = "ä2"}));
  EXPECT_EQ(input(R"({"type":"size","n":7,"width":800,"height":600,"scale":2})", 7),
            (InputEvent{.kind = InputEvent::Kind::size, .size = {800, 600}, .scale = 2.0f}));
  EXPECT_EQ(input(R"({"type":"leave","n":8})", 8), (InputEvent{.kind = InputEvent::Kind::leave}));
}

TEST(ClientMessage, AnythingElseIsRefused) {
  for (const std::string& wrong : std::initializer_list<std::string>{
           "",
           "{",
           "7",
           "[]",
           "null",
           R"({"type":7})",
           R"({"type":"run","n":1})",
           R"({"type":"hello"})",
           R"({"type":"hello","codec":"gif"})",
           R"({"type":"ack"})",
           R"({"type":"ack","picture":-1})",
           R"({"type":"ack","picture":4294967296})",
           R"({"type":"ack","picture":1.5})",
           R"({"type":"pointer","n":1,"x":1,"y":2,"buttons":8,"touch":false})",
           R"({"type":"pointer","n":1,"x":1e999,"y":2,"buttons":0,"touch":false})",
           R"({"type":"pointer","n":1,"x":70000,"y":2,"buttons":0,"touch":false})",
           R"({"type":"pointer","n":1,"x":"1","y":2,"buttons":0,"touch":false})",
           R"({"type":"pointer","x":1,"y":2,"buttons":0,"touch":false})",
           R"({"type":"pointer","n":1,"x":1,"y":2,"buttons":0})",
           R"({"type":"key","n":1,"key":"F1","down":true})",
           R"({"type":"key","n":1,"key":"Enter","down":1})",
           R"({"type":"size","n":1,"width":8,"height":600,"scale":1})",
           R"({"type":"size","n":1,"width":800,"height":5000,"scale":1})",
           R"({"type":"size","n":1,"width":800,"height":600,"scale":0})",
           R"({"type":"text","n":1,"text":"a\nb"})",
           "{\"type\":\"text\",\"n\":1,\"text\":\"\xff\"}",
           R"({"type":"text","n":1,"text":")" + std::string(65, 'a') + "\"}",
           R"({"type":"leave","n":1,"pad":")" + std::string(longestClientMessage, 'a') + "\"}",
           std::string(4000, '[')})
    EXPECT_FALSE(parseClientMessage(wrong)) << wrong.substr(0, 80);
}

TEST(StreamMessage, HeaderIsLittleEndian) {
  const std::byte content[]{std::byte{0xaa}};
  const auto message = streamMessage({StreamKind::h264Key, true, 0x01020304, 0x05060708, 1280, 720}, content);
  const std::vector<std::uint8_t> expected{2, 1, 0, 0, 4, 3, 2, 1, 8, 7, 6, 5, 0x00, 0x05, 0xd0, 0x02, 0xaa};
  ASSERT_EQ(message.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(static_cast<std::uint8_t>(message[i]), expected[i]) << i;
}

}  // namespace
}  // namespace bedmix
