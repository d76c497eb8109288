// Passwords: argon2id (RFC 9106) by libsodium, on a thread of its own, one at a time: each takes 64 MiB and some tenths
// of a second, so that guessing is dear for who steals the hashes, and asking costs the server a bounded share of one
// processor.
//
// Threads: any; answers come on the thread of passwords.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "core/value/expected.h"
#include "server/threads/strand.h"

namespace race::server {

/// What a hash costs. The default is RFC 9106's second recommended option, with fewer lanes: 64 MiB, 3 passes.
struct PasswordCost {
  unsigned long long passes = 3;
  std::size_t bytes = std::size_t{64} << 20U;
};

class Passwords {
 public:
  static constexpr std::size_t kShortest = 10, kLongest = 200;  // characters; bytes
  static constexpr std::size_t kMostWaiting = 8;

  explicit Passwords(PasswordCost cost = {}) : cost_(cost) {}

  /// Whether it can be one. Error `out_of_range`, with the path `password`: too short, too long, no UTF-8, or
  /// the account's name.
  static Expected<void> check(const std::string& password, const std::string& account);

  /// Computes the hash of a password on this thread; for the command line. Error `unavailable`: no memory.
  Expected<std::string> hash_here(const std::string& password) const;

  using Hashed = std::function<void(Expected<std::string>)>;
  /// `hashed` gets the hash. Error `unavailable`: kMostWaiting others wait, no memory, or the server ends.
  void hash(std::string password, Hashed hashed);

  using Compared = std::function<void(Expected<bool>)>;
  /// `compared` gets whether the hash is of this password. An empty hash, of an account that does not exist, takes as
  /// long as any other and is of none. Errors as of hash().
  void compare(std::string password, std::string hash, Compared compared);

 private:
  /// Does `work` when those before it are done; false: too many wait.
  bool post(std::function<void()> work);
  const std::string& hash_of_nothing();

  const PasswordCost cost_;
  std::string hash_of_nothing_;  // of its thread
  std::atomic<std::size_t> waiting_{0};
  Pool pool_{1, 0, "passwords"};
};

}  // namespace race::server
