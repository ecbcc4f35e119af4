// SPDX-License-Identifier: MIT
#pragma once

#include "replay/channel.h"

#include <cstddef>
#include <optional>
#include <string>

namespace bedmix {

/// What a process that reads a file is asked for. It answers with a text of what is wrong, empty where
/// nothing is and the frame lies in that half of the memory both share.
struct FrameRequest {
  std::size_t index, half;
};

/// Has the next frame read into one half of the memory while the one that was asked for is taken out of the
/// other: the one that follows if the steps from frame to frame stay as they are.
class ReadAhead {
 public:
  struct Read {
    std::size_t half;
    std::string trouble;
  };

  /// Waits for frame `index` of so many. `ask` sends a FrameRequest.
  template <class Ask>
  Read frame(Channel& child, std::size_t index, std::size_t frames, const Ask& ask) {
    if (!asked_ || asked_->index != index) {
      settle(child);
      ask(FrameRequest{index, 0});
      asked_ = {index, 0};
    }
    Read read{asked_->half, child.getAll<std::string>()};
    asked_.reset();
    const std::size_t next = index + (last_ ? index - *last_ : 1);
    if (next < frames) {
      ask(FrameRequest{next, 1 - read.half});
      asked_ = {next, 1 - read.half};
    }
    last_ = index;
    return read;
  }

  /// Takes the answer that is still to come, so that something else can be asked.
  void settle(Channel& child) {
    if (asked_) child.getAll<std::string>();
    asked_.reset();
  }

 private:
  std::optional<FrameRequest> asked_;
  std::optional<std::size_t> last_;  // that was handed over
};

}  // namespace bedmix
