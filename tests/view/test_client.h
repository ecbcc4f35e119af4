// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/stream_message.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

// A browser's part, played by hand: it can do what no browser does.

namespace bedmix::test {

using Headers = std::map<std::string, std::string>;

struct HttpAnswer {
  int status = 0;
  Headers headers;
  std::string body;
};

/// The parts of a URL the server has given: http://HOST:PORT/?token=TOKEN.
struct ServerUrl {
  explicit ServerUrl(const std::string& url);
  std::string host() const { return "127.0.0.1:" + std::to_string(port); }
  std::string cookie() const { return "bedmix-" + std::to_string(port) + "=" + token; }

  std::uint16_t port = 0;
  std::string token;
};

/// One request on a connection of its own; headers beside a right Host, or instead of it.
HttpAnswer request(const ServerUrl& server, const std::string& target, const Headers& headers = {},
                   const std::string& method = "GET");

/// A client of /ws. Throws boost::system::system_error where it is refused or cut off.
class TestClient {
 public:
  TestClient(const ServerUrl& server, const Headers& headers);
  /// With the right cookie and Origin.
  explicit TestClient(const ServerUrl& server);

  void send(const std::string& json);
  /// The next message; none within the time, after which no other may be asked for.
  struct Message {
    StreamHeader header;
    std::string content;
  };
  std::optional<Message> receive(std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// Waits for a notice that contains the text.
  bool hears(const std::string& text);
  /// Goes without a word, in the middle of whatever is being sent.
  void vanish();
  bool isOpen() const { return socket_.is_open(); }

 private:
  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_{io_};
};

}  // namespace bedmix::test
