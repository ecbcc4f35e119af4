// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_host.h"
#include "engine/core/diagnostic.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bedmix {

/// Where to listen: "127.0.0.1:PORT", "[::1]:PORT"; port 0 takes a free one. An address that is not of the
/// loopback needs `isPublic`.
struct ListenOptions {
  std::string address = "127.0.0.1:0";
  bool isPublic = false;
  double idleSeconds = 60.0;    // a connection without any message, the pings' answers included, is closed
  std::size_t mostClients = 8;  // connections to /ws at one time
};

/// Page, WebSocket and saved files on one port. Who has the token of control or of viewing, and comes from
/// the page itself, is let in (see access.h). Works in a thread of its own; a client that is slow, silent or
/// malicious delays no other.
class ViewServer {
 public:
  /// Listens from now on. `host` must outlive it. Fails where the address is wrong, taken or not loopback.
  static Result<std::unique_ptr<ViewServer>> create(const ListenOptions& options, ViewHost& host);
  ~ViewServer();  // says goodbye and closes

  /// With their tokens: whoever opens the first controls, whoever opens the second looks on.
  std::string controlUrl() const;
  std::string viewUrl() const;

  /// From any thread: hands a message to a client; nothing where it has left.
  void send(ClientId client, SharedBytes message);
  /// From any thread: /saved/NAME gives these bytes from now on, and nothing else can be asked for by name.
  void publish(const std::string& name, const std::string& type, SharedBytes content);

 private:
  struct State;
  explicit ViewServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
