// SPDX-License-Identifier: MIT
#pragma once

#include "replay/channel.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <sys/types.h>

namespace bedmix {

/// Work that may crash or never come to an end, in a process of its own: a copy of this one that shares
/// nothing with it but a channel. It has no other file open but the standard ones, takes no part in Ctrl-C,
/// leaves no core, and ends with the work, with a failure, or when its parent does.
class ChildProcess {
 public:
  using Work = std::function<void(Channel& parent)>;

  /// Throws std::system_error where the system has no process left.
  explicit ChildProcess(const Work& task);
  /// Ends it, whatever it is doing.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  Channel& channel() { return channel_; }
  /// Why it has closed its channel, e.g. "SIGSEGV". To be asked once, when it has.
  std::string end();

  /// In the child: it ends unless it asks again before it has computed for so long.
  static void allowComputing(std::chrono::seconds most);
  /// In the child: it can take up so many bytes more, and no more than half of what the machine has.
  static void allowMemory(std::uintmax_t most);

 private:
  Channel channel_;
  pid_t id_;
};

}  // namespace bedmix
