// Attempts: how often logins may fail, of an address and of an account, so that passwords cannot be guessed over the
// network. A token bucket each (RFC 2697's single rate, counted in failures): so many at once, then one more in so
// long.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
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
  // More than of an address: who guesses from many must not keep the account's owner out.
  static constexpr Rate kOfAccount{50, std::chrono::seconds(20)};
  static constexpr std::size_t kMost = 10'000;  // addresses, and names; beyond that, the fullest are forgotten

  /// How long to wait before the next attempt; nothing: it may be made.
  std::optional<std::chrono::milliseconds> wait(const std::string& address, const std::string& account, Time now)
      EXCLUDES(mutex_);
  /// An attempt begins: it counts as failed until not_failed() is said, so that attempts at once count all.
  void begun(const std::string& address, const std::string& account, Time now) EXCLUDES(mutex_);
  /// It succeeded, or was not made after all: what begun() has taken is given back.
  void not_failed(const std::string& address, const std::string& account, Time now) EXCLUDES(mutex_);

 private:
  /// A bucket is known by when it will be full again: what is left in it follows from that.
  struct Buckets {
    std::map<std::string, Time> full;                // by key
    std::set<std::pair<Time, std::string>> by_time;  // the same
  };
  static double left(const Buckets& buckets, const std::string& key, const Rate& rate, Time now);
  static void add(Buckets& buckets, const std::string& key, const Rate& rate, double failures, Time now);
  static void forget(Buckets& buckets, const std::string& key);

  services::Mutex mutex_;
  Buckets addresses_ GUARDED_BY(mutex_), accounts_ GUARDED_BY(mutex_);
};

}  // namespace race::server
