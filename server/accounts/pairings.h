// Pairings: a person who has logged in lets a phone in beside them, as a display: the phone reads a code from their
// page, and gets a token of their account for it, which may less (TokenScope). A code is used once and soon, and a
// login has one at a time.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "server/accounts/account.h"
#include "server/accounts/role.h"
#include "services/mutex.h"

namespace race::server {

/// What a phone gets for a code.
struct Pairing {
  Identity by;             // who has let it in
  TokenScope scope = {};   // of its token
  std::string place = {};  // where it stands, a name as that of a display; empty: nowhere in particular
  std::int64_t days = 1;   // until its token expires
};

class Pairings {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kLife{60};
  static constexpr std::size_t kMost = 64;          // codes that wait
  static constexpr std::size_t kMostOfAccount = 8;  // so that one account does not keep out the others

  /// Too many codes wait: those of the account, or those of all.
  struct Full {
    std::size_t most = 0;
    bool of_account = false;
    std::chrono::milliseconds wait{};  // until the first of them is too old
  };
  /// A new code, in place of the one that the same login (Identity::token) had made: a page that is loaded again uses
  /// up no more than one.
  tl::expected<std::string, Full> issue(Pairing pairing, Time now) EXCLUDES(mutex_);
  /// Takes the code back. Nothing: there is none, it was used, or is too old. Each takes as long: a code is looked for
  /// by its digest.
  std::optional<Pairing> take(std::string_view code, Time now) EXCLUDES(mutex_);

 private:
  struct Entry {
    Pairing pairing;
    Time until;
  };

  /// Those that wait, of one account or of all.
  std::optional<Full> full(std::string_view account, Time now) const REQUIRES(mutex_);

  services::Mutex mutex_;
  std::map<std::string, Entry, std::less<>> pairings_ GUARDED_BY(mutex_);  // by digest
};

}  // namespace race::server
