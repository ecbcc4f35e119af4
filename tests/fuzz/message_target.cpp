// SPDX-License-Identifier: MIT
#include "app/view/client_message.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"

#include <cmath>
#include <cstdlib>

// Messages of the page: whatever is taken for one holds what the rest of the program relies on.

namespace bedmix::fuzz {

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

bool isPlace(Vec2f at) { return std::abs(at.x) <= 65536.0f && std::abs(at.y) <= 65536.0f; }

void examine(const InputEvent& event) {
  demand(isPlace(event.at) && isPlace(event.turn) && event.buttons <= 7);
  demand(static_cast<std::size_t>(event.key) < panelKeyNames.size());
  demand(event.text.size() <= 64);
  if (event.kind != InputEvent::Kind::size) return;
  demand(event.size.width >= 16 && event.size.width <= 4096);
  demand(event.size.height >= 16 && event.size.height <= 4096);
  demand(event.scale >= 0.5f && event.scale <= 4.0f);
}

}  // namespace

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> all{
      R"({"type":"hello","codec":"h264"})",
      R"({"type":"ack","picture":7})",
      R"({"type":"control"})",
      R"({"type":"pointer","n":1,"x":12.5,"y":700,"buttons":1,"touch":false})",
      R"({"type":"wheel","n":2,"x":12.5,"y":700,"right":0,"up":-1.5})",
      R"({"type":"key","n":3,"key":"ArrowLeft","down":true})",
      R"({"type":"text","n":4,"text":"2.5ä"})",
      R"({"type":"size","n":5,"width":1280,"height":720,"scale":2})",
      R"({"type":"leave","n":6})"};
  return all;
}

void mutate(std::string& input, Rng& rng) {
  static const std::vector<std::string> pieces{
      "1e308",   "-1e308",  "1e999",    "-0",   "4294967296",        "null", "true", "[]", "{}", "\"\"",
      "\\u0000", "\\ud800", "\"n\":1,", "\xff", "\"type\":\"size\","};
  if (below(2, rng) == 0) return mutateBytes(input, rng);
  const std::string& piece = oneOf(pieces, rng);
  const std::size_t at = below(input.size() + 1, rng);
  input.replace(at, below(5, rng), piece);
}

}  // namespace bedmix::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bedmix;
  const auto message = parseClientMessage({reinterpret_cast<const char*>(data), size});
  if (!message) {
    fuzz::demand(!message.problems.empty());
    return 0;
  }
  if (const auto* input = std::get_if<NumberedInput>(&*message)) fuzz::examine(input->event);
  return 0;
}
