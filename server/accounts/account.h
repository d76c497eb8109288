// Account and AccountToken: what the server knows of who may use it.
//
// Threads: any; values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// What who has a token is, beside their account: what it may do is the lower of the two roles.
struct TokenScope {
  std::optional<Role> role = {};  // nothing: that of the account, whatever that will be
  bool local = false;             // a display at the cell, as an account of kLocal
  std::string display = {};       // the name of the display that was paired; empty: none was
  bool operator==(const TokenScope&) const = default;

  /// Errors `not_accepted`, with the field as path: `role`: the account may less, or one of the two is a process;
  /// `local`: a process.
  Expected<void> check(const Account& account) const;
};

/// A secret by which an account is known. The secret itself is not kept.
struct AccountToken {
  static constexpr std::size_t kLongestLabel = 100;  // characters

  std::string digest;  // 64 hexadecimal digits (secret.h)
  std::string account;
  std::string label;  // what it is for: "login", or what its owner says
  std::int64_t created = 0;
  std::int64_t expires = 0;  // [ms since 1970]; 0: never
  TokenScope scope = {};
  bool operator==(const AccountToken&) const = default;
};

}  // namespace race::server
