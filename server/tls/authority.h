// Authority: certificates for a server in a local network, where nobody else signs any. Made once, kept in a folder.
//
// Threads: one at a time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"

namespace race::server {

/// What a TLS server needs, as PEM.
struct ServerCertificate {
  std::string chain;  // its certificate, then that of the authority
  std::string key;
};

class Authority {
 public:
  static constexpr int kAuthorityDays = 3650, kServerDays = 397, kRenewDays = 30;

  /// Reads the authority in the folder (ca.pem, ca.key), or makes it, for names as in `hosts`. `now`: seconds since
  /// 1970. Errors, with the path: `io`, `corrupt` (what is there is no certificate with its key), `not_accepted`
  /// (others may read the key).
  static Expected<Authority> open(const std::string& folder, std::int64_t now);

  /// Its certificate, as PEM: what a phone is to trust.
  const std::string& certificate() const { return certificate_; }
  /// SHA-256 of it, as people compare it: "AB:CD:...".
  const std::string& fingerprint() const { return fingerprint_; }

  /// A certificate for these names and addresses: the one in the folder (server.pem, server.key) if it is for all of
  /// them and has kRenewDays left, else a new one. Errors as of open(); `out_of_range`: a name that the authority is
  /// not good for (no private address, and no name without a dot or in `.local`).
  Expected<ServerCertificate> certificate_for(const std::vector<std::string>& names, std::int64_t now) const;

 private:
  Authority(std::string folder, std::string certificate, std::string key, std::string fingerprint)
      : folder_(std::move(folder)),
        certificate_(std::move(certificate)),
        key_(std::move(key)),
        fingerprint_(std::move(fingerprint)) {}
  std::string folder_, certificate_, key_, fingerprint_;
};

/// Whether an address is private (RFC 1918, RFC 4193, link-local, loopback), or a name is of a local network: without a
/// dot, or in `.local`.
bool is_local_name(const std::string& name);

}  // namespace race::server
