#include "server/http/listening.h"

namespace race::server {

void listen_at(asio::ip::tcp::acceptor& acceptor, const std::string& address, std::uint16_t port) {
  using asio::ip::tcp;
  const bool is_all = address == "::";
  const tcp::endpoint endpoint(asio::ip::make_address(address), port);
  error_code no_ipv6;
  acceptor.open(endpoint.protocol(), no_ipv6);
  if (no_ipv6 && is_all) return listen_at(acceptor, "0.0.0.0", port);
  if (no_ipv6) throw boost::system::system_error(no_ipv6);
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  if (is_all) acceptor.set_option(asio::ip::v6_only(false));
  acceptor.bind(endpoint);
  acceptor.listen();
}

std::string text_of(const asio::ip::address& address) {
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address.to_string();
  return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string();
}

}  // namespace race::server
