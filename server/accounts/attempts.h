// Attempts: how often logins and codes of pairings may fail, of an address, of an account, and of an account from one
// address, so that neither can be guessed over the network. A token bucket each (RFC 2697's single rate, counted in
// failures): so many at once, then one more in so long.
//
// Who guesses does not keep the owner of an account out: one address cannot empty the account's bucket, and from where
// the account has logged in lately that bucket does not count. But beside an attacker who has several addresses, an
// owner at an address that is new to the server may have to wait.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "services/mutex.h"

namespace race::server {

class Attempts {
 public:
  using Time = std::chrono::steady_clock::time_point;

  struct Rate {
    double burst;                      // failures at once
    std::chrono::milliseconds refill;  // until one more
  };
  static constexpr Rate kOfAddress{10, std::chrono::seconds(6)};
  static constexpr Rate kOfAccount{50, std::chrono::seconds(20)};
  static constexpr Rate kOfPair{10, std::chrono::seconds(30)};  // slower than the account's bucket is filled again
  static constexpr std::size_t kMost = 10'000;  // addresses, names, and pairs; beyond that, the fullest are forgotten
  static constexpr std::size_t kMostKnown = 8;  // addresses of an account that has logged in there; the oldest go
  static constexpr std::size_t kMostKnownOfAll = 2'000;
  static constexpr std::chrono::hours kKnown{30 * 24};  // since it has logged in there

  /// One login, a password that is shown again, or a code of a pairing, which names no account.
  struct Attempt {
    std::string address, account;  // empty: the address alone counts
    bool counts_for_account = true;
  };
  /// An attempt begins: it counts as failed until one of the others is said, so that attempts at once count all. Else
  /// how long to wait before the next; if that is for the account's sake, the address has failed once more.
  tl::expected<Attempt, std::chrono::milliseconds> begin(const std::string& address, const std::string& account,
                                                         Time now) EXCLUDES(mutex_);
  /// It was not made after all: what begin() has taken is given back.
  void drop(const Attempt& attempt, Time now) EXCLUDES(mutex_);
  /// The same; and the account is known at this address.
  void succeed(const Attempt& attempt, Time now) EXCLUDES(mutex_);

 private:
  /// A bucket is known by when it will be full again: what is left in it follows from that.
  struct Buckets {
    std::map<std::string, Time> full;                // by key
    std::set<std::pair<Time, std::string>> by_time;  // the same
  };
  static double left(const Buckets& buckets, const std::string& key, const Rate& rate, Time now);
  static void add(Buckets& buckets, const std::string& key, const Rate& rate, double failures, Time now);
  static void forget(Buckets& buckets, const std::string& key);

  /// Where an account has logged in.
  struct Known {
    std::string account, address;
    Time last;
  };
  bool is_known(const std::string& address, const std::string& account, Time now) const REQUIRES(mutex_);
  tl::expected<Attempt, std::chrono::milliseconds> begin_at(const std::string& address, Time now) REQUIRES(mutex_);
  void give_back(const Attempt& attempt, Time now) REQUIRES(mutex_);

  services::Mutex mutex_;
  Buckets addresses_ GUARDED_BY(mutex_), accounts_ GUARDED_BY(mutex_), pairs_ GUARDED_BY(mutex_);
  std::deque<Known> known_ GUARDED_BY(mutex_);  // the oldest first
};

}  // namespace race::server
