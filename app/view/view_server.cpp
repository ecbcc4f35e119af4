// SPDX-License-Identifier: MIT
#include "app/view/view_server.h"

#include "app/view/view_connection.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <chrono>
#include <thread>
#include <utility>

namespace bedmix {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr std::chrono::milliseconds farewell{300};  // for clients to take the last message
constexpr std::chrono::milliseconds breath{100};    // after a connection that could not be accepted

Diagnostic cannot(const ListenOptions& options, const std::string& why, Trouble trouble = Trouble::input) {
  return {{"--listen " + options.address}, why, trouble};
}

/// Splits "127.0.0.1:8080" and "[::1]:8080".
Result<tcp::endpoint> endpointOf(const ListenOptions& options) {
  const std::string& text = options.address;
  const std::size_t colon = text.rfind(':');
  std::string host = text.substr(0, std::min(colon, text.size()));
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  unsigned port = 0;
  const char* const last = text.data() + text.size();
  const char* const digits = colon == std::string::npos ? last : text.data() + colon + 1;
  const auto [end, error] = std::from_chars(digits, last, port);
  boost::system::error_code wrong;
  const auto address = asio::ip::make_address(host, wrong);
  if (wrong || digits == last || error != std::errc{} || end != last || port > 65535)
    return cannot(options, "must be an IP address and a port, e.g. 127.0.0.1:8080 or [::1]:0");
  if (!address.is_loopback() && !options.isPublic)
    return cannot(
        options,
        "other machines could reach this address, and nothing is encrypted; listen on 127.0.0.1 and use "
        "ssh -L, or say --public");
  return tcp::endpoint(address, static_cast<std::uint16_t>(port));
}

std::string textOf(const tcp::endpoint& endpoint) {
  const std::string address = endpoint.address().to_string();
  return endpoint.address().is_v6() ? fmt::format("[{}]:{}", address, endpoint.port())
                                    : fmt::format("{}:{}", address, endpoint.port());
}

}  // namespace

struct ViewServer::State {
  ViewRoom room;  // first: connections tell it when they end
  asio::io_context io{1};
  tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};
  std::jthread thread;

  State(const ListenOptions& options, ViewHost& host) : room(options, host) {}

  void accept() {
    acceptor.async_accept([this](boost::system::error_code error, Socket socket) {
      if (!acceptor.is_open()) return;
      if (error) return acceptLater();
      socket.set_option(tcp::no_delay(true), error);
      serveConnection(std::move(socket), room);
      accept();
    });
  }

  /// Where there are no descriptors left, asking again at once would not free one.
  void acceptLater() {
    pause.expires_after(breath);
    pause.async_wait([this](boost::system::error_code error) {
      if (!error && acceptor.is_open()) accept();
    });
  }

  Result<Done> listen() {
    const Result<tcp::endpoint> endpoint = endpointOf(room.options);
    if (!endpoint) return endpoint.problems;
    boost::system::error_code error;
    acceptor.open(endpoint->protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(*endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
      return cannot(room.options,
                    fmt::format("cannot listen there: {}; port 0 takes a free one", error.message()),
                    Trouble::file);
    const tcp::endpoint local = acceptor.local_endpoint();
    room.address = textOf(local);
    return Done{};
  }
};

ViewServer::ViewServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Result<std::unique_ptr<ViewServer>> ViewServer::create(const ListenOptions& options, ViewHost& host) {
  auto state = std::make_unique<State>(options, host);
  if (const auto listens = state->listen(); !listens) return listens.problems;
  state->accept();
  state->thread = std::jthread([&io = state->io] { io.run(); });
  return std::unique_ptr<ViewServer>(new ViewServer(std::move(state)));
}

ViewServer::~ViewServer() {
  State& s = *state_;
  asio::post(s.io, [&s] {
    boost::system::error_code ignored;
    s.acceptor.close(ignored);
    for (const auto& [id, member] : s.room.members) member.client->close("the view has ended");
    auto timer = std::make_shared<asio::steady_timer>(s.io, farewell);
    timer->async_wait([&s, timer](boost::system::error_code) { s.io.stop(); });
  });
  s.thread.join();
  s.room.members.clear();
}

std::string ViewServer::controlUrl() const {
  return fmt::format("http://{}/?token={}", state_->room.address, state_->room.tokens.control);
}
std::string ViewServer::viewUrl() const {
  return fmt::format("http://{}/?token={}", state_->room.address, state_->room.tokens.view);
}

void ViewServer::send(ClientId client, SharedBytes message) {
  asio::post(state_->io, [&room = state_->room, client, message = std::move(message)]() mutable {
    if (const auto found = room.members.find(client); found != room.members.end())
      found->second.client->send(std::move(message));
  });
}

void ViewServer::publish(const std::string& name, const std::string& type, SharedBytes content) {
  asio::post(state_->io, [&room = state_->room, name, type, content = std::move(content)]() mutable {
    room.files[name] = {type, std::move(content)};
  });
}

}  // namespace bedmix
