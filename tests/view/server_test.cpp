// SPDX-License-Identifier: MIT
#include "app/view/view_server.h"
#include "tests/view/test_client.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace bedmix {
namespace {

using namespace std::chrono_literals;
using test::Headers;
using test::ServerUrl;
using test::TestClient;

/// Notes what the server tells.
class NotingHost final : public ViewHost {
 public:
  void joined(ClientId client, Role role) override {
    note([&] { roles[client] = role; });
  }
  void changed(ClientId client, Role role) override {
    note([&] { roles[client] = role; });
  }
  void left(ClientId client) override {
    note([&] { roles.erase(client); });
  }
  void received(ClientId client, const ClientMessage& message) override {
    note([&] { messages.emplace_back(client, message); });
  }

  /// Whether it comes to be true within a time.
  template <class Condition>
  bool comes(const Condition& condition) {
    std::unique_lock lock(mutex);
    return changed_.wait_for(lock, 20s, condition);
  }
  std::size_t controllers() const {
    std::size_t count = 0;
    for (const auto& [id, role] : roles) count += role == Role::controller ? 1 : 0;
    return count;
  }

  std::mutex mutex;
  std::map<ClientId, Role> roles;
  std::vector<std::pair<ClientId, ClientMessage>> messages;

 private:
  template <class Change>
  void note(const Change& change) {
    const std::lock_guard lock(mutex);
    change();
    changed_.notify_all();
  }
  std::condition_variable changed_;
};

SharedBytes picture(std::uint32_t number, std::size_t bytes) {
  return std::make_shared<const std::vector<std::byte>>(
      streamMessage({.picture = number}, std::vector<std::byte>(bytes)));
}

class ViewServerFaults : public ::testing::Test {
 protected:
  static ListenOptions options() {
    ListenOptions made;
    made.mostClients = 4;
    return made;
  }
  Headers rightHeaders() const { return {{"Cookie", url.cookie()}, {"Origin", "http://" + url.host()}}; }
  /// Whether the upgrade is refused with these headers.
  bool isRefused(const Headers& headers) const {
    try {
      TestClient client(url, headers);
    } catch (const boost::system::system_error&) {
      return true;
    }
    return false;
  }
  ClientId onlyClient() {
    EXPECT_TRUE(host.comes([&] { return host.roles.size() == 1; }));
    const std::lock_guard lock(host.mutex);
    return host.roles.begin()->first;
  }

  NotingHost host;
  std::unique_ptr<ViewServer> server = std::move(*ViewServer::create(options(), host));
  ServerUrl url{server->controlUrl()}, viewUrl{server->viewUrl()};
};

TEST_F(ViewServerFaults, TokenLetsInOnceAndTheCookieFromThenOn) {
  const auto entered = test::request(url, "/?token=" + url.token);
  EXPECT_EQ(entered.status, 303);
  EXPECT_EQ(entered.headers.at("Location"), "/");
  EXPECT_EQ(entered.headers.at("Set-Cookie").rfind(url.cookie() + "; HttpOnly; SameSite=Strict", 0), 0u);
  const auto page = test::request(url, "/", {{"Cookie", url.cookie()}});
  EXPECT_EQ(page.status, 200);
  EXPECT_NE(page.body.find("<canvas"), std::string::npos);
  for (const char* file : {"/viewer.js", "/viewer.css"})
    EXPECT_EQ(test::request(url, file, {{"Cookie", url.cookie()}}).status, 200) << file;
  const auto head = test::request(url, "/", {{"Cookie", url.cookie()}}, "HEAD");
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.body, "");
}

TEST_F(ViewServerFaults, EveryAnswerForbidsWhatThePageDoesNotNeed) {
  for (const auto& answer : {test::request(url, "/"), test::request(url, "/", {{"Cookie", url.cookie()}}),
                             test::request(url, "/none", {{"Cookie", url.cookie()}})}) {
    const std::string& policy = answer.headers.at("Content-Security-Policy");
    for (const char* part : {"default-src 'none'", "script-src 'self'", "frame-ancestors 'none'"})
      EXPECT_NE(policy.find(part), std::string::npos) << part;
    EXPECT_EQ(policy.find("unsafe"), std::string::npos);
    EXPECT_EQ(answer.headers.at("X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(answer.headers.at("Referrer-Policy"), "no-referrer");
    EXPECT_EQ(answer.headers.at("Cache-Control"), "no-store");
  }
}

TEST_F(ViewServerFaults, StrangersAreRefused) {
  EXPECT_EQ(test::request(url, "/").status, 403);
  EXPECT_EQ(test::request(url, "/?token=" + std::string(32, '0')).status, 403);
  EXPECT_EQ(test::request(url, "/viewer.js?token=" + url.token).status, 403)
      << "only the page takes the token";
  EXPECT_EQ(test::request(url, "/", {{"Cookie", "bedmix-1=" + url.token}}).status, 403);
  EXPECT_EQ(test::request(url, "/?token=" + url.token, {{"Host", "evil.example"}}).status, 403);
  EXPECT_EQ(test::request(url, "/", {{"Cookie", url.cookie()}}, "POST").status, 405);
  Headers headers = rightHeaders();
  EXPECT_FALSE(isRefused(headers));
  EXPECT_TRUE(isRefused({{"Origin", headers["Origin"]}})) << "no cookie";
  EXPECT_TRUE(isRefused({{"Cookie", headers["Cookie"]}})) << "no origin";
  for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1", "http://127.0.0.1:1"}) {
    headers["Origin"] = origin;
    EXPECT_TRUE(isRefused(headers)) << origin;
  }
  headers = rightHeaders();
  headers["Host"] = "evil.example:80";
  headers["Origin"] = "http://evil.example:80";
  EXPECT_TRUE(isRefused(headers));
}

TEST_F(ViewServerFaults, HostThatIsNotOursIsNotRepeated) {
  const auto answer = test::request(url, "/", {{"Host", "evil.example; script-src *"}});
  EXPECT_EQ(answer.status, 403);
  EXPECT_EQ(answer.headers.at("Content-Security-Policy").find("evil"), std::string::npos);
}

TEST_F(ViewServerFaults, TunnelsOfOtherPortsHaveCookiesOfTheirOwn) {
  const auto entered = test::request(url, "/?token=" + url.token, {{"Host", "localhost:9000"}});
  EXPECT_EQ(entered.headers.at("Set-Cookie").rfind("bedmix-9000=", 0), 0u);
  const Headers through{{"Host", "localhost:9000"}, {"Cookie", "bedmix-9000=" + url.token}};
  EXPECT_EQ(test::request(url, "/", through).status, 200);
}

TEST_F(ViewServerFaults, StrangersLeaveRoomForOthers) {
  boost::asio::io_context io;
  std::vector<boost::asio::ip::tcp::socket> idle;
  for (int i = 0; i < 100; ++i) {
    idle.emplace_back(io);
    idle.back().connect({boost::asio::ip::make_address("127.0.0.1"), url.port});
  }
  // What is beyond the limit is closed at once, not kept.
  boost::system::error_code error;
  char byte = 0;
  idle.back().read_some(boost::asio::buffer(&byte, 1), error);
  EXPECT_TRUE(error);
  idle.clear();
  // Once they have gone, it answers again.
  int status = 0;
  for (int i = 0; i < 500 && status == 0; ++i) try {
      status = test::request(url, "/").status;
    } catch (const boost::system::system_error&) {
      std::this_thread::sleep_for(10ms);
    }
  EXPECT_EQ(status, 403);
}

TEST_F(ViewServerFaults, OnlySavedFilesCanBeHadByName) {
  const auto content = std::make_shared<const std::vector<std::byte>>(3, std::byte{'x'});
  server->publish("scene-1.toml", "application/toml", content);
  const Headers cookie{{"Cookie", url.cookie()}};
  const auto file = test::request(url, "/saved/scene-1.toml", cookie);
  EXPECT_EQ(file.status, 200);
  EXPECT_EQ(file.body, "xxx");
  EXPECT_EQ(file.headers.at("Content-Disposition"), "attachment; filename=\"scene-1.toml\"");
  EXPECT_EQ(test::request(url, "/saved/scene-1.toml").status, 403);
  for (const char* other :
       {"/saved/", "/saved/scene-1.tom", "/saved/../saved/scene-1.toml", "/saved/..%2fetc%2fpasswd",
        "/etc/passwd", "/saved//etc/passwd", "/saved/scene-1.toml/"})
    EXPECT_EQ(test::request(url, other, cookie).status, 404) << other;
}

TEST_F(ViewServerFaults, InputOfTheControllerAloneCounts) {
  TestClient first(url), second(url), looker(viewUrl);
  ASSERT_TRUE(first.hears(R"("role": "controller")"));
  ASSERT_TRUE(second.hears(R"("role": "viewer", "mayControl": true)"));
  ASSERT_TRUE(looker.hears(R"("role": "viewer", "mayControl": false)"));
  looker.send(R"({"type":"control"})");
  looker.send(R"({"type":"leave","n":1})");
  second.send(R"({"type":"leave","n":2})");
  first.send(R"({"type":"leave","n":3})");
  ASSERT_TRUE(host.comes([&] { return !host.messages.empty(); }));
  second.send(R"({"type":"control"})");
  ASSERT_TRUE(first.hears(R"("role": "viewer")"));
  ASSERT_TRUE(second.hears(R"("role": "controller")"));
  first.send(R"({"type":"leave","n":4})");
  first.send(R"({"type":"ack","picture":9})");
  second.send(R"({"type":"leave","n":5})");
  ASSERT_TRUE(host.comes([&] { return host.messages.size() == 3; }));
  const std::lock_guard lock(host.mutex);
  EXPECT_EQ(host.controllers(), 1u);
  EXPECT_EQ(std::get<NumberedInput>(host.messages[0].second).number, 3u);
  for (const std::size_t i : {1, 2})
    if (const auto* input = std::get_if<NumberedInput>(&host.messages[i].second))
      EXPECT_EQ(input->number, 5u);
    else
      EXPECT_TRUE(std::holds_alternative<Acknowledgement>(host.messages[i].second));
}

TEST_F(ViewServerFaults, ControlGoesOnToTheNextWhereTheControllerLeaves) {
  auto first = std::make_unique<TestClient>(url);
  ASSERT_TRUE(first->hears("controller"));
  TestClient second(url);
  ASSERT_TRUE(second.hears("viewer"));
  first->vanish();
  EXPECT_TRUE(second.hears(R"("role": "controller")"));
}

TEST_F(ViewServerFaults, WrongMessagesEndTheirConnectionAlone) {
  TestClient good(url);
  ASSERT_TRUE(good.hears("controller"));
  for (const std::string& wrong :
       {std::string("{"), std::string(R"({"type":"run"})"), std::string(3 * longestClientMessage, ' ')}) {
    TestClient bad(url);
    EXPECT_THROW(
        {
          bad.send(wrong);
          bad.hears("anything");
        },
        boost::system::system_error)
        << wrong.substr(0, 20);
  }
  ASSERT_TRUE(host.comes([&] { return host.roles.size() == 1; }));
  good.send(R"({"type":"leave","n":1})");
  EXPECT_TRUE(host.comes([&] { return host.messages.size() == 1; }));
}

TEST_F(ViewServerFaults, ThereIsRoomForSoManyAndNoMore) {
  std::vector<std::unique_ptr<TestClient>> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(std::make_unique<TestClient>(url));
    ASSERT_TRUE(clients.back()->hears("role"));
  }
  EXPECT_TRUE(isRefused(rightHeaders()));
  clients.back()->vanish();
  ASSERT_TRUE(host.comes([&] { return host.roles.size() == 3; }));
  EXPECT_FALSE(isRefused(rightHeaders()));
}

TEST_F(ViewServerFaults, FiftyReconnectsInTheMiddleOfPictures) {
  TestClient steady(url);
  ASSERT_TRUE(steady.hears("role"));
  for (int i = 0; i < 50; ++i) {
    TestClient client(url);
    ASSERT_TRUE(client.hears("role"));
    {
      const std::lock_guard lock(host.mutex);
      for (const auto& [id, role] : host.roles) server->send(id, picture(1, 4 << 20));
    }
    if (i % 2 == 0) client.vanish();
    const auto got = steady.receive();
    ASSERT_TRUE(got);
    EXPECT_EQ(got->content.size(), std::size_t{4} << 20);
  }
  EXPECT_TRUE(host.comes([&] { return host.roles.size() <= 2; }));
}

TEST_F(ViewServerFaults, ClientThatTakesNothingDelaysNoOtherAndIsLetGo) {
  TestClient fast(url), stalled(url);
  ASSERT_TRUE(fast.hears("role"));
  ASSERT_TRUE(host.comes([&] { return host.roles.size() == 2; }));
  std::vector<ClientId> ids;
  {
    const std::lock_guard lock(host.mutex);
    for (const auto& [id, role] : host.roles) ids.push_back(id);
  }
  for (std::uint32_t k = 1; k <= 40; ++k) {  // 40 MiB, more than waits for anybody
    for (const ClientId id : ids) server->send(id, picture(k, 1 << 20));
    const auto got = fast.receive();
    ASSERT_TRUE(got);
    EXPECT_EQ(got->header.picture, k);
  }
  EXPECT_TRUE(host.comes([&] { return host.roles.size() == 1; })) << "its memory is not held";
}

TEST_F(ViewServerFaults, SilentConnectionsAreClosed) {
  ListenOptions brief = options();
  brief.idleSeconds = 1.0;
  auto other = std::move(*ViewServer::create(brief, host));
  // Its pings are not answered, as nobody reads.
  TestClient client(ServerUrl(other->controlUrl()));
  ASSERT_TRUE(host.comes([&] { return host.roles.size() == 1; }));
  EXPECT_TRUE(host.comes([&] { return host.roles.empty(); }));
}

TEST_F(ViewServerFaults, EndsWhileClientsAreServed) {
  TestClient client(url);
  const ClientId id = onlyClient();
  for (std::uint32_t k = 1; k <= 8; ++k) server->send(id, picture(k, 1 << 20));
  server.reset();
  EXPECT_THROW(
      {
        while (client.receive()) continue;
      },
      boost::system::system_error);
}

TEST(ViewServer, ListensOnTheLoopbackUnlessToldOtherwise) {
  NotingHost host;
  const auto fails = [&](const std::string& address, bool isPublic, const std::string& why) {
    ListenOptions options;
    options.address = address;
    options.isPublic = isPublic;
    const auto server = ViewServer::create(options, host);
    return !server && toString(server.problems.front()).find(why) != std::string::npos;
  };
  EXPECT_TRUE(fails("0.0.0.0:0", false, "ssh -L"));
  EXPECT_FALSE(fails("0.0.0.0:0", true, ""));
  EXPECT_FALSE(fails("[::1]:0", false, ""));
  for (const char* wrong :
       {"", "127.0.0.1", "127.0.0.1:", "127.0.0.1:99999", "localhost:80", "127.0.0.1:80x", ":80"})
    EXPECT_TRUE(fails(wrong, false, "must be an IP address and a port")) << wrong;
  const auto server = ViewServer::create({}, host);
  const ServerUrl url((*server)->controlUrl());
  EXPECT_TRUE(fails("127.0.0.1:" + std::to_string(url.port), false, "cannot listen there"));
}

}  // namespace
}  // namespace bedmix
