// Account and AccountToken: what the server knows of who may use it.
//
// Threads: any; values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/accounts/role.h"

namespace race::server {

struct Account {
  static constexpr std::size_t kLongestName = 40;

  std::string name;  // letters, digits, `_`, `-` and `.`, the first a letter or digit
  Role role = Role::observer;
  // Of a process: the component groups that it may bring. Of people: nothing, or kLocal alone.
  std::vector<std::string> groups = {};
  std::string password_hash = {};  // argon2id (passwords.h); empty: nobody can log in with a password
  std::int64_t created = 0;        // [ms since 1970]
  bool operator==(const Account&) const = default;

  /// Errors, with the field as path: `name`; `missing` (a process without a group); `not_accepted` (a group or a
  /// password of what is none or has none).
  Expected<void> check() const;
};

/// A secret by which an account is known. The secret itself is not kept.
struct AccountToken {
  static constexpr std::size_t kLongestLabel = 100;  // characters

  std::string digest;  // 64 hexadecimal digits (secret.h)
  std::string account;
  std::string label;  // what it is for: "login", or what its owner says
  std::int64_t created = 0;
  std::int64_t expires = 0;  // [ms since 1970]; 0: never
  bool operator==(const AccountToken&) const = default;
};

}  // namespace race::server
