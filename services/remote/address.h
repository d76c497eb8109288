// Addresses of servers, as command lines name them. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::remote {

/// Where a server is.
struct Address {
  std::string host;
  std::uint16_t port = 80;
  bool tls = false;
};

/// Reads `http://HOST[:PORT]`, with or without a `/` at its end, or the same with `https` (port 443). Error `syntax`.
Expected<Address> read_address(std::string_view url);

}  // namespace race::remote
