// How the server listens at a port.
#pragma once

#include <cstdint>
#include <string>

#include "server/http/beast.h"

namespace race::server {

/// Opens and binds. `address` "::" is of IPv4, too; without IPv6, of that alone. Throws boost::system::system_error.
void listen_at(asio::ip::tcp::acceptor& acceptor, const std::string& address, std::uint16_t port);

/// Of a client by IPv4 on a port of both, the IPv4 address.
std::string text_of(const asio::ip::address& address);

}  // namespace race::server
