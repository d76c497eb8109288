#include "services/remote/address.h"

#include <charconv>

namespace race::remote {

Expected<Address> read_address(std::string_view url) {
  const auto refuse = [&] {
    return unexpected(ErrorCode::syntax,
                      "must be of the form http://HOST:PORT or https://HOST:PORT, got `" + std::string(url) + "`");
  };
  constexpr std::string_view kPlain = "http://", kTls = "https://";
  Address address;
  address.tls = url.starts_with(kTls);
  if (!address.tls && !url.starts_with(kPlain)) return refuse();
  if (address.tls) address.port = 443;
  std::string_view rest = url.substr(address.tls ? kTls.size() : kPlain.size());
  if (rest.ends_with('/')) rest.remove_suffix(1);
  const auto colon = rest.find(':');
  address.host = std::string(rest.substr(0, colon));
  if (address.host.empty() || address.host.find_first_of("/?#@[] ") != std::string::npos) return refuse();
  if (colon == std::string_view::npos) return address;
  const std::string_view port = rest.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc() || end != port.data() + port.size() || address.port == 0) return refuse();
  return address;
}

}  // namespace race::remote
