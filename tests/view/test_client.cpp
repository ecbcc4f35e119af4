// SPDX-License-Identifier: MIT
#include "tests/view/test_client.h"

#include <cstring>

namespace bedmix::test {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

namespace {

tcp::endpoint endpointOf(const ServerUrl& server) {
  return {asio::ip::make_address("127.0.0.1"), server.port};
}

template <class T>
T littleEndian(const std::string& bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i)
    value = static_cast<T>(value | static_cast<T>(static_cast<unsigned char>(bytes[at + i])) << (8 * i));
  return value;
}

}  // namespace

ServerUrl::ServerUrl(const std::string& url) {
  const std::size_t colon = url.rfind(':'), token0 = url.find("token=");
  port = static_cast<std::uint16_t>(std::stoi(url.substr(colon + 1)));
  token = url.substr(token0 + 6);
}

HttpAnswer request(const ServerUrl& server, const std::string& target, const Headers& headers,
                   const std::string& method) {
  asio::io_context io;
  tcp::socket socket(io);
  socket.connect(endpointOf(server));
  http::request<http::empty_body> asked(http::string_to_verb(method), target, 11);
  asked.set(http::field::host, server.host());
  for (const auto& [name, value] : headers) asked.set(name, value);
  http::write(socket, asked);
  http::response_parser<http::string_body> parser;
  if (method == "HEAD") parser.skip(true);
  beast::flat_buffer buffer;
  http::read(socket, buffer, parser);
  HttpAnswer answer{static_cast<int>(parser.get().result_int()), {}, parser.get().body()};
  for (const auto& field : parser.get())
    answer.headers[std::string(field.name_string())] = std::string(field.value());
  return answer;
}

TestClient::TestClient(const ServerUrl& server, const Headers& headers) {
  beast::get_lowest_layer(socket_).connect(endpointOf(server));
  std::string host = server.host();
  if (const auto other = headers.find("Host"); other != headers.end()) host = other->second;
  socket_.set_option(beast::websocket::stream_base::decorator([&](beast::websocket::request_type& asked) {
    for (const auto& [name, value] : headers)
      if (name != "Host") asked.set(name, value);
  }));
  socket_.handshake(host, "/ws");
}

TestClient::TestClient(const ServerUrl& server)
    : TestClient(server, {{"Cookie", server.cookie()}, {"Origin", "http://" + server.host()}}) {}

void TestClient::send(const std::string& json) { socket_.write(asio::buffer(json)); }

std::optional<TestClient::Message> TestClient::receive(std::chrono::milliseconds patience) {
  beast::flat_buffer buffer;
  std::optional<beast::error_code> outcome;
  socket_.async_read(buffer, [&](beast::error_code error, std::size_t) { outcome = error; });
  io_.restart();
  io_.run_for(patience);
  if (!outcome) return std::nullopt;
  if (*outcome) throw beast::system_error(*outcome);
  const std::string bytes = beast::buffers_to_string(buffer.data());
  if (bytes.size() < streamHeaderBytes) throw std::runtime_error("a message without a header");
  Message message;
  message.header.kind = static_cast<StreamKind>(bytes[0]);
  message.header.isSharp = bytes[1] != 0;
  message.header.picture = littleEndian<std::uint32_t>(bytes, 4);
  message.header.input = littleEndian<std::uint32_t>(bytes, 8);
  message.header.width = littleEndian<std::uint16_t>(bytes, 12);
  message.header.height = littleEndian<std::uint16_t>(bytes, 14);
  message.content = bytes.substr(streamHeaderBytes);
  return message;
}

bool TestClient::hears(const std::string& text) {
  while (const auto message = receive())
    if (message->header.kind == StreamKind::notice && message->content.find(text) != std::string::npos)
      return true;
  return false;
}

void TestClient::vanish() {
  auto& socket = beast::get_lowest_layer(socket_).socket();
  socket.set_option(asio::socket_base::linger(true, 0));
  socket.close();
}

}  // namespace bedmix::test
