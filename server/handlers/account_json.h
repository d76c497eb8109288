// What the routes of accounts share: accounts and tokens as clients see them.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "core/value/expected.h"
#include "core/value/fields.h"
#include "core/value/value.h"
#include "server/accounts/account.h"
#include "server/accounts/attempts.h"
#include "server/http/message.h"

namespace race::server {

/// schemas/account.json; never its password.
Value account_json(const Account& account);
/// schemas/account_tokens.json, an item.
Value token_json(const AccountToken& token);
/// The field `role`; one that is none is a violation.
std::optional<Role> read_role(Fields& fields, Fields::Need need);

/// 429, with `Retry-After`.
Reply too_many_attempts(std::chrono::milliseconds wait);
/// What a comparison of passwords says of the attempt; an error: it was not made.
void settle(Attempts& attempts, const Attempts::Attempt& attempt, const Expected<bool>& is_right);

inline constexpr std::int64_t kDay = std::int64_t{24} * 60 * 60 * 1000;  // ms
/// Whether no token was made because what was looked at before is another one by now (Accounts::issue_login,
/// issue_for).
inline bool has_changed(const Error& error) {
  return error.code == ErrorCode::not_found || error.code == ErrorCode::conflict;
}

/// Logins end after this [ms].
inline constexpr std::int64_t kLoginLife = std::int64_t{12} * 60 * 60 * 1000;

}  // namespace race::server
