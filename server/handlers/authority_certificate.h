// AuthorityCertificate: what clients may know of the authority of this server (server/tls/authority.h).
//
// Threads: any; set before requests come.
#pragma once

#include <string>

namespace race::server {

struct AuthorityCertificate {
  std::string certificate;  // PEM; empty: the server serves no network
  std::string fingerprint;  // "AB:CD:..."
};

}  // namespace race::server
