// Tickets: who opens a WebSocket. A browser cannot send a token with the request that opens one, and a token in its
// address would stand in logs; so a page asks for a ticket with its token, and puts that into the address. A ticket is
// used once and soon.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "server/accounts/role.h"
#include "services/mutex.h"

namespace race::server {

class Tickets {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kLife{30};
  static constexpr std::size_t kMost = 1000;  // the oldest go

  /// A new ticket of `identity`.
  std::string issue(Identity identity, Time now) EXCLUDES(mutex_);
  /// Takes the ticket back. Nothing: there is none, it was used, or is too old.
  std::optional<Identity> take(std::string_view ticket, Time now) EXCLUDES(mutex_);

 private:
  struct Entry {
    Identity identity;
    Time until;
  };
  void forget_old(Time now) REQUIRES(mutex_);

  services::Mutex mutex_;
  std::map<std::string, Entry, std::less<>> tickets_ GUARDED_BY(mutex_);  // by digest
};

}  // namespace race::server
