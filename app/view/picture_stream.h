// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_host.h"
#include "app/view/view_session.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bedmix {

/// Where the stream sends: the server, or a test.
class StreamOutput {
 public:
  virtual ~StreamOutput() = default;
  virtual void send(ClientId client, SharedBytes message) = 0;
  virtual void publish(const std::string& name, const std::string& type, SharedBytes content) = 0;
};

/// Draws a session for its clients, in a thread of its own: the newest state only, at most two pictures on
/// their way to a client, none where nothing has changed, and a sharp one when it has come to rest. A slow
/// client gets fewer pictures and delays no other.
class PictureStream final : public ViewHost {
 public:
  /// Makes the session in the stream's thread, where its OpenGL lives.
  using MakeSession = std::function<Result<ViewSession>()>;

  PictureStream();
  ~PictureStream() override;

  /// Begins; returns when the session is there, or why it is not. `output` must outlive the stream's end().
  Result<Done> begin(const MakeSession& make, StreamOutput& output);
  /// Ends the session: recordings are closed, no client is sent anything any more. What its model says last.
  std::string end();

  void joined(ClientId client, Role role) override;
  void changed(ClientId client, Role role) override;
  void left(ClientId client) override;
  void received(ClientId client, const ClientMessage& message) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
