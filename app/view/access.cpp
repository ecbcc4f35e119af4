// SPDX-License-Identifier: MIT
#include "app/view/access.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <random>

namespace bedmix {

namespace {

/// Where the port of "127.0.0.1:80" or "[::1]:80" begins; the end where there is none.
std::size_t portColon(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const bool isInAddress = host.ends_with(']');
  return colon == std::string_view::npos || isInAddress ? host.size() : colon;
}

/// Whether it is an IP address and no name.
bool isAddress(std::string_view host) {
  const bool isV6 = host.starts_with('[') && host.ends_with(']');
  const std::string_view signs = isV6 ? "[]0123456789abcdefABCDEF:." : "0123456789.";
  return !host.empty() && host.find_first_not_of(signs) == std::string_view::npos;
}

}  // namespace

std::string makeToken() {
  std::random_device random;  // the system's own, for secrets
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

bool sameSecret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

std::optional<Role> Tokens::roleOf(std::string_view token) const {
  if (sameSecret(token, control)) return Role::controller;
  if (sameSecret(token, view)) return Role::viewer;
  return std::nullopt;
}

std::string_view pathOf(std::string_view target) { return target.substr(0, target.find('?')); }

std::string_view tokenInQuery(std::string_view target) {
  constexpr std::string_view name = "token=";
  const std::size_t query = target.find('?');
  if (query == std::string_view::npos) return {};
  for (std::string_view rest = target.substr(query + 1); !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find('&'));
    if (part.starts_with(name)) return part.substr(name.size());
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  }
  return {};
}

std::string cookieName(std::string_view host) {
  const std::size_t colon = portColon(host);
  return fmt::format("bedmix-{}", colon == host.size() ? "80" : host.substr(colon + 1));
}

std::string_view cookieValue(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    std::string_view part = header.substr(0, header.find(';'));
    header.remove_prefix(std::min(part.size() + 1, header.size()));
    while (part.starts_with(' ')) part.remove_prefix(1);
    if (part.size() > name.size() && part.starts_with(name) && part[name.size()] == '=')
      return part.substr(name.size() + 1);
  }
  return {};
}

std::string cookieHeader(std::string_view name, std::string_view value) {
  return fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", name, value);
}

bool isOurHost(std::string_view host, std::string_view listenAddress) {
  if (host == listenAddress) return true;
  const std::size_t port = portColon(listenAddress);
  const std::string_view address = listenAddress.substr(0, port);
  if ((address == "0.0.0.0" || address == "[::]") && host.ends_with(listenAddress.substr(port)) &&
      isAddress(host.substr(0, portColon(host))))
    return true;
  for (const std::string_view name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (!host.starts_with(name)) continue;
    const std::string_view rest = host.substr(name.size());
    if (rest.empty()) return true;
    return rest.size() > 1 && rest.size() <= 6 && rest[0] == ':' &&
           std::all_of(rest.begin() + 1, rest.end(), [](char c) { return c >= '0' && c <= '9'; });
  }
  return false;
}

bool isOurOrigin(std::string_view origin, std::string_view host) {
  constexpr std::string_view scheme = "http://";
  return !host.empty() && origin.size() == scheme.size() + host.size() && origin.starts_with(scheme) &&
         origin.ends_with(host);
}

bool isLoopback(std::string_view address) { return address.starts_with("127.") || address == "::1"; }

}  // namespace bedmix
