// SPDX-License-Identifier: MIT
#pragma once

#include "render/image.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace bedmix::test {

/// What a player finds in a film. Opened by libavformat, decoded by libavcodec, taken to RGB as its tags say.
struct DecodedMovie {
  std::vector<Image> frames;
  std::vector<double> times;  // s, when each is shown
  double duration = 0.0;      // s
  double framesPerSecond = 0.0;
  bool bt709Limited = false;  // all four tags say so
  bool yuv420 = false;
  std::string codec, tag, profile;  // "h264", "avc1", "High"
};

/// Empty where it cannot be decoded.
DecodedMovie decode(const std::filesystem::path& path);

}  // namespace bedmix::test
