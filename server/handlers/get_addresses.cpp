// GET /api/v1/addresses: where the network reaches this server.
#include "server/handlers/handlers.h"
#include "server/handlers/network_addresses.h"

namespace race::server {

List addresses_json(const NetworkAddresses& addresses) {
  List list;
  for (const std::string& url : addresses.urls) list.push_back(Dict{{"url", url}});
  return list;
}

Handled get_addresses(const Request&, NetworkAddresses& addresses) {
  return ok(Dict{{"addresses", addresses_json(addresses)}});
}

}  // namespace race::server
