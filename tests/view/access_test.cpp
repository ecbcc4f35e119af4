// SPDX-License-Identifier: MIT
#include "app/view/access.h"

#include <gtest/gtest.h>

#include <set>

namespace bedmix {
namespace {

TEST(ViewAccess, TokensAre128RandomBits) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) seen.insert(makeToken());
  EXPECT_EQ(seen.size(), 100u);
  EXPECT_EQ(seen.begin()->size(), 32u);
  EXPECT_EQ(seen.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(ViewAccess, TokensAllowTheirRoleAndNothingElseDoes) {
  const Tokens tokens;
  EXPECT_EQ(tokens.roleOf(tokens.control), Role::controller);
  EXPECT_EQ(tokens.roleOf(tokens.view), Role::viewer);
  for (const std::string& wrong :
       {std::string(), tokens.control.substr(1), tokens.control + "0", std::string(32, '0')})
    EXPECT_FALSE(tokens.roleOf(wrong)) << wrong;
}

TEST(ViewAccess, FindsTheTokenOfAQuery) {
  EXPECT_EQ(tokenInQuery("/?token=abc"), "abc");
  EXPECT_EQ(tokenInQuery("/?x=1&token=abc&y=2"), "abc");
  for (const char* none : {"/", "/?", "/?tokens=abc", "/token=abc", "/?x=token=abc"})
    EXPECT_EQ(tokenInQuery(none), "") << none;
  EXPECT_EQ(pathOf("/saved/a?token=b"), "/saved/a");
}

TEST(ViewAccess, FindsItsCookieAmongOthers) {
  EXPECT_EQ(cookieValue("a=1; bedmix-80=xyz; b=2", "bedmix-80"), "xyz");
  for (const char* none : {"", "bedmix-8080=xyz", "xbedmix-80=xyz", "bedmix-80", "a=bedmix-80=xyz"})
    EXPECT_EQ(cookieValue(none, "bedmix-80"), "") << none;
  const std::string header = cookieHeader(cookieName("localhost"), "xyz");
  for (const char* part : {"bedmix-80=xyz", "HttpOnly", "SameSite=Strict", "Path=/"})
    EXPECT_NE(header.find(part), std::string::npos) << part;
}

TEST(ViewAccess, HostMustBeOurs) {
  for (const char* ours : {"127.0.0.1:8080", "localhost:9", "[::1]:65535", "localhost", "10.0.0.7:8080"})
    EXPECT_TRUE(isOurHost(ours, "10.0.0.7:8080")) << ours;
  for (const char* other :
       {"", "evil.example", "127.0.0.1.evil.example", "127.0.0.1:80.evil.example", "localhost.",
        "localhost:", "localhost:123456", "127.0.0.11:80", "10.0.0.7:80", "10.0.0.7", "LOCALHOST:x"})
    EXPECT_FALSE(isOurHost(other, "10.0.0.7:8080")) << other;
}

TEST(ViewAccess, CookieIsNamedByThePortTheBrowserSees) {
  EXPECT_EQ(cookieName("127.0.0.1:9000"), "bedmix-9000");
  EXPECT_EQ(cookieName("[::1]:9000"), "bedmix-9000");
  EXPECT_EQ(cookieName("[::1]"), "bedmix-80");
}

TEST(ViewAccess, AnyAddressOfTheMachineIsOursWhereItListensOnAll) {
  for (const char* ours : {"10.0.0.7:8080", "[fe80::1]:8080"}) {
    EXPECT_TRUE(isOurHost(ours, "0.0.0.0:8080")) << ours;
    EXPECT_TRUE(isOurHost(ours, "[::]:8080")) << ours;
    EXPECT_FALSE(isOurHost(ours, "10.0.0.8:8080")) << ours;
  }
  for (const char* other : {"10.0.0.7:80", "10.0.0.7", "evil.example:8080", ":8080", "10.0.0.7.example:8080"})
    EXPECT_FALSE(isOurHost(other, "0.0.0.0:8080")) << other;
}

TEST(ViewAccess, OriginMustBeThatOfThePage) {
  EXPECT_TRUE(isOurOrigin("http://127.0.0.1:8080", "127.0.0.1:8080"));
  for (const char* other :
       {"", "null", "https://127.0.0.1:8080", "http://127.0.0.1:8081", "http://localhost:8080",
        "http://127.0.0.1:8080.evil.example", "http://evil.example/http://127.0.0.1:8080"})
    EXPECT_FALSE(isOurOrigin(other, "127.0.0.1:8080")) << other;
  EXPECT_FALSE(isOurOrigin("http://", ""));
}

}  // namespace
}  // namespace bedmix
