// SPDX-License-Identifier: MIT
#include "app/view/view_connection.h"

#include "app/view/viewer_page.h"

#include <fmt/format.h>

#include <boost/asio/dispatch.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

namespace bedmix {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Request = http::request<http::empty_body>;
using Answer = http::response<http::string_body>;

constexpr std::chrono::seconds patience{20};                // for a request, and for a write to be taken
constexpr std::size_t longestHeader = 16 * 1024;            // bytes
constexpr std::size_t mostConnections = 64;                 // beside clients
constexpr std::size_t mostWaiting = std::size_t{16} << 20;  // bytes to a client that does not take them

/// A client at /ws: writes one message after the other, reads one after the other.
class WebSocketClient final : public ViewClient, public std::enable_shared_from_this<WebSocketClient> {
 public:
  WebSocketClient(beast::tcp_stream stream, ViewRoom& room, Role mayBe)
      : socket_(std::move(stream)), room_(room), mayBe_(mayBe) {
    ++room_.clients;
  }
  ~WebSocketClient() override { --room_.clients; }

  void accept(const Request& request) {
    beast::get_lowest_layer(socket_).expires_never();
    websocket::stream_base::timeout timeouts{};
    timeouts.handshake_timeout = patience;
    timeouts.idle_timeout = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::duration<double>(room_.options.idleSeconds));
    timeouts.keep_alive_pings = true;
    socket_.set_option(timeouts);
    socket_.read_message_max(longestClientMessage);
    socket_.binary(true);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (!error) self->begin();
    });
  }

  void send(SharedBytes message) override {
    waitingBytes_ += message->size();
    waiting_.push_back(std::move(message));
    if (waitingBytes_ > mostWaiting) return drop();
    if (waiting_.size() == 1 && isOpen_) write();
  }

  void close(const std::string& why) override { close(websocket::close_code::going_away, why); }

 private:
  void begin() {
    isOpen_ = true;
    id_ = room_.join(shared_from_this(), mayBe_);
    read();
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->leave();
      self->take();
    });
  }

  void take() {
    const auto data = buffer_.cdata();
    const auto message = parseClientMessage({static_cast<const char*>(data.data()), data.size()});
    buffer_.clear();
    if (!id_) return;  // it could not be written to
    if (!message) return close(websocket::close_code::policy_error, "the message makes no sense");
    if (std::holds_alternative<ControlRequest>(*message))
      room_.requestControl(*id_);
    else if (!std::holds_alternative<NumberedInput>(*message) || room_.roleOf(*id_) == Role::controller)
      room_.host.received(*id_, *message);
    read();
  }

  void write() {
    const auto begun = ++writes_;
    // A reader that takes nothing must not keep what is meant for it.
    auto timer = std::make_shared<boost::asio::steady_timer>(socket_.get_executor(), patience);
    timer->async_wait([self = weak_from_this(), begun](beast::error_code error) {
      if (const auto client = self.lock(); client && !error && client->writes_ == begun) client->drop();
    });
    socket_.async_write(boost::asio::buffer(*waiting_.front()),
                        [self = shared_from_this(), timer](beast::error_code error, std::size_t) {
                          timer->cancel();
                          ++self->writes_;
                          if (error) return self->leave();
                          self->waitingBytes_ -= self->waiting_.front()->size();
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) self->write();
                        });
  }

  void close(websocket::close_code code, const std::string& why) {
    if (std::exchange(isClosing_, true)) return;
    socket_.async_close({code, why}, [self = shared_from_this()](beast::error_code) { self->leave(); });
  }

  /// Without waiting for the other side.
  void drop() {
    beast::error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
  }

  void leave() {
    if (id_) room_.leave(*std::exchange(id_, std::nullopt));
  }

  websocket::stream<beast::tcp_stream> socket_;
  ViewRoom& room_;
  Role mayBe_;
  std::optional<ClientId> id_;
  beast::flat_buffer buffer_{longestClientMessage};
  std::deque<SharedBytes> waiting_;  // the first is being written
  std::size_t waitingBytes_ = 0;
  std::uint64_t writes_ = 0;  // begun and ended
  bool isOpen_ = false, isClosing_ = false;
};

/// Reads one request after the other until one upgrades.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Socket socket, ViewRoom& room) : stream_(std::move(socket)), room_(room) {
    ++room_.connections;
  }
  ~HttpConnection() { --room_.connections; }

  void read() {
    parser_.emplace();
    parser_->header_limit(longestHeader);
    parser_->body_limit(0);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->answer();
                     });
  }

 private:
  static std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

  std::optional<Role> roleByCookie(const Request& request) const {
    return room_.tokens.roleOf(
        cookieValue(view(request[http::field::cookie]), cookieName(view(request[http::field::host]))));
  }

  void answer() {
    const Request& request = parser_->get();
    const std::string_view target = view(request.target()), path = pathOf(target);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return send(plain(http::status::method_not_allowed, "only GET and HEAD"));
    if (request.count(http::field::host) > 1 || request.count(http::field::origin) > 1)
      return send(plain(http::status::bad_request, "one Host and one Origin, please"));
    if (!isOurHost(view(request[http::field::host]), room_.address))
      return send(plain(http::status::forbidden, "this is not the address of this server"));
    if (const std::string_view token = tokenInQuery(target); path == "/" && !token.empty())
      return send(enter(token));
    const std::optional<Role> role = roleByCookie(request);
    if (!role)
      return send(plain(http::status::forbidden,
                        "open the address that bedmix view printed: it has a token that lets you in"));
    if (websocket::is_upgrade(request)) return upgrade(request, path, *role);
    send(content(path));
  }

  Answer enter(std::string_view token) const {
    if (!room_.tokens.roleOf(token))
      return plain(http::status::forbidden, "this token is not, or no longer, valid");
    Answer answer = plain(http::status::see_other, "");
    answer.set(http::field::location, "/");
    answer.set(http::field::set_cookie,
               cookieHeader(cookieName(view(parser_->get()[http::field::host])), token));
    return answer;
  }

  void upgrade(const Request& request, std::string_view path, Role role) {
    if (path != "/ws") return send(plain(http::status::not_found, "there is nothing here"));
    if (!isOurOrigin(view(request[http::field::origin]), view(request[http::field::host])))
      return send(plain(http::status::forbidden, "only the page of this server may do that"));
    if (room_.isFull())
      return send(plain(http::status::service_unavailable, "too many are looking on already"));
    std::make_shared<WebSocketClient>(std::move(stream_), room_, role)->accept(request);
  }

  Answer content(std::string_view path) const {
    for (const PageFile& file : viewerPage())
      if (path == file.path) return file200(file.type, std::string(file.content));
    constexpr std::string_view saved = "/saved/";
    const auto found =
        path.starts_with(saved) ? room_.files.find(path.substr(saved.size())) : room_.files.end();
    if (found == room_.files.end()) return plain(http::status::not_found, "there is nothing here");
    const auto& [name, file] = *found;
    const auto& bytes = *file.content;
    Answer answer =
        file200(file.type, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    answer.set(http::field::content_disposition, fmt::format("attachment; filename=\"{}\"", name));
    return answer;
  }

  static Answer file200(std::string_view type, std::string text) {
    Answer answer(http::status::ok, 11, std::move(text));
    answer.set(http::field::content_type, beast::string_view(type.data(), type.size()));
    return answer;
  }
  static Answer plain(http::status status, const std::string& text) {
    Answer answer(status, 11, text + '\n');
    answer.set(http::field::content_type, "text/plain; charset=utf-8");
    return answer;
  }

  void send(Answer answer) {
    const Request& request = parser_->get();
    // The page may load nothing but its own files and be shown in no other page. Some browsers do not count
    // the WebSocket among 'self'; a Host that is not ours is not repeated.
    const std::string_view host = view(request[http::field::host]);
    answer.set("Content-Security-Policy",
               fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; "
                           "img-src 'self' blob: data:; connect-src 'self'{}; base-uri 'none'; "
                           "form-action 'none'; frame-ancestors 'none'",
                           isOurHost(host, room_.address) ? fmt::format(" ws://{}", host) : ""));
    answer.set("X-Content-Type-Options", "nosniff");
    answer.set("Referrer-Policy", "no-referrer");
    answer.set(http::field::cache_control, "no-store");
    answer.keep_alive(request.keep_alive());
    answer.prepare_payload();
    if (request.method() == http::verb::head) answer.body().clear();
    answer_ = std::move(answer);
    serializer_.emplace(answer_);
    write();
  }

  /// Part by part: a large file may take long, as long as each part is taken in time.
  void write() {
    stream_.expires_after(patience);
    http::async_write_some(stream_, *serializer_,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                             if (error) return;
                             if (!self->serializer_->is_done()) return self->write();
                             if (self->answer_.keep_alive()) return self->read();
                             self->stream_.socket().shutdown(Socket::shutdown_send, error);
                           });
  }

  beast::tcp_stream stream_;
  ViewRoom& room_;
  beast::flat_buffer buffer_{2 * longestHeader};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Answer answer_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
};

}  // namespace

void serveConnection(Socket socket, ViewRoom& room) {
  if (room.connections >= mostConnections) return;
  std::make_shared<HttpConnection>(std::move(socket), room)->read();
}

}  // namespace bedmix
