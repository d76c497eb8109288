// NetworkAddresses: where the network reaches this server.
//
// Threads: any; set before requests come.
#pragma once

#include <string>
#include <vector>

#include "core/value/value.h"

namespace race::server {

struct NetworkAddresses {
  std::vector<std::string> urls;  // "https://192.168.1.5:8443"; none: it listens on this machine alone
};

/// schemas/addresses.json, `addresses`.
List addresses_json(const NetworkAddresses& addresses);

}  // namespace race::server
