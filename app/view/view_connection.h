// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/access.h"
#include "app/view/view_server.h"

#include <boost/asio/ip/tcp.hpp>
#include <map>
#include <memory>
#include <string>

// The server's own: what its connections share, and the two kinds there are. All of it lives in the server's
// thread.

namespace bedmix {

using Socket = boost::asio::ip::tcp::socket;

/// A client at /ws.
class ViewClient {
 public:
  virtual ~ViewClient() = default;
  virtual void send(SharedBytes message) = 0;
  /// Says goodbye, and why.
  virtual void close(const std::string& why) = 0;
};

struct PublishedFile {
  std::string type;
  SharedBytes content;
};

/// What all connections know.
struct ViewRoom {
  ViewRoom(const ListenOptions& listen, ViewHost& tells) : options(listen), host(tells) {}

  ListenOptions options;
  ViewHost& host;
  Tokens tokens;
  std::string address;                                      // "127.0.0.1:4711", that it listens on
  std::map<std::string, PublishedFile, std::less<>> files;  // by name, under /saved/

  struct Member {
    std::shared_ptr<ViewClient> client;
    Role mayBe = Role::viewer;  // by its token
    Role role = Role::viewer;
  };
  std::map<ClientId, Member> members;  // in the order they came
  ClientId lastId = 0;
  std::size_t clients = 0;      // at /ws, those that are still shaking hands included
  std::size_t connections = 0;  // of all kinds but these

  bool isFull() const { return clients >= options.mostClients; }
  ClientId join(std::shared_ptr<ViewClient> client, Role mayBe);
  void leave(ClientId client);
  /// Hands the control over, where it may have it.
  void requestControl(ClientId client);
  Role roleOf(ClientId client) const;

 private:
  void setRole(ClientId client, Role role);
  bool hasController() const;
};

/// Serves one connection: page, files, and from the upgrade on a client. Owns itself until it ends. One too
/// many is closed: whoever has no token must not use up what the others need.
void serveConnection(Socket socket, ViewRoom& room);

}  // namespace bedmix
