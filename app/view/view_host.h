// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/client_message.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace bedmix {

/// Numbers clients in the order they came; never used twice.
using ClientId = std::uint64_t;
enum class Role { controller, viewer };

/// What the server tells of its clients, all in its own thread. Must return at once.
class ViewHost {
 public:
  virtual ~ViewHost() = default;
  virtual void joined(ClientId client, Role role) = 0;
  virtual void changed(ClientId client, Role role) = 0;
  virtual void left(ClientId client) = 0;
  /// Input comes from the one controller alone.
  virtual void received(ClientId client, const ClientMessage& message) = 0;
};

/// A binary message to a client: a header (see stream_message.h) and what it announces.
using SharedBytes = std::shared_ptr<const std::vector<std::byte>>;

}  // namespace bedmix
