// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_host.h"

#include <optional>
#include <string>
#include <string_view>

// Who is let in, after the model of Jupyter: a secret in the URL once, a cookie from then on, and only the
// page itself may talk to the server. Pure functions, free of the library that carries the bytes.

namespace bedmix {

/// A secret: 128 random bits in hexadecimal.
std::string makeToken();
/// Compares in a time that tells nothing of where they differ.
bool sameSecret(std::string_view a, std::string_view b);

struct Tokens {
  std::string control = makeToken(), view = makeToken();

  /// What a token allows; nothing where it is none.
  std::optional<Role> roleOf(std::string_view token) const;
};

/// The value of `token` in the query of a target: "/?token=abc"; empty where there is none.
std::string_view tokenInQuery(std::string_view target);
/// The path of a target, without its query.
std::string_view pathOf(std::string_view target);

/// The name of the cookie, by the port of the Host that the browser sees, which ssh -L may have changed: two
/// views have different ones there, and browsers do not tell cookies apart by these.
std::string cookieName(std::string_view host);
/// The value of a cookie in a Cookie header; empty where it is not there.
std::string_view cookieValue(std::string_view header, std::string_view name);
/// The Set-Cookie header: not for scripts, and not for requests that other pages cause.
std::string cookieHeader(std::string_view name, std::string_view value);

/// Whether a Host header names this server: a loopback name with any port, as through ssh -L it is another,
/// exactly the address it was told to listen on or, where that is all of the machine's ("0.0.0.0:80"), an IP
/// address with its port. A page of somebody else's whose name is made to point here (DNS rebinding) has that
/// name in its Host.
bool isOurHost(std::string_view host, std::string_view listenAddress);
/// Whether an Origin header is that of a page that came from `host`.
bool isOurOrigin(std::string_view origin, std::string_view host);

/// Whether an IP address is that of the loopback.
bool isLoopback(std::string_view address);

}  // namespace bedmix
