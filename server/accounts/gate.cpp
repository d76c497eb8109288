#include "server/accounts/gate.h"

#include <algorithm>

#include "server/wire/calendar.h"

namespace race::server {
namespace {

constexpr char kPage = '~';  // between an account and the tag of a page

constexpr std::string_view kBearer = "bearer ";  // RFC 6750, 2.1; its case does not count (RFC 9110, 11.1)

bool is_bearer(std::string_view authorization) {
  return std::ranges::equal(authorization.substr(0, kBearer.size()), kBearer,
                            [](char c, char small) { return c == small || c + 'a' - 'A' == small; });
}

tl::unexpected<Denial> unknown() { return tl::unexpected(Denial{true, "login", "log in: this server has accounts"}); }

}  // namespace

Expected<std::string> author_for(const Identity& identity, std::string author) {
  const std::string& account = identity.account;
  if (account.empty() || author == account || author.starts_with(account + kPage)) return author;
  if (author.empty()) return account;
  return unexpected(ErrorCode::rights, "the author must be " + quote(account), "author");
}

std::optional<Identity> Gate::identify(const Credentials& credentials) const {
  if (!credentials.ticket.empty()) {
    auto identity = tickets_.take(credentials.ticket, std::chrono::steady_clock::now());
    if (identity && is_current(*identity)) return identity;
    return std::nullopt;
  }
  if (is_bearer(credentials.authorization)) {
    const std::string_view secret = credentials.authorization.substr(kBearer.size());
    if (key_.is(secret)) return key_.identity();
    if (auto identity = accounts_.identify(secret, now_ms())) return identity;
  }
  if (accounts_.empty()) return Identity();  // a token of accounts that were there once does no harm
  return std::nullopt;
}

tl::expected<Identity, Denial> Gate::admit(std::string_view method, std::string_view pattern,
                                           const Credentials& credentials) const {
  const auto right = Rights::table().of_route(method, pattern);
  auto identity = identify(credentials);
  if (!identity) {
    if (right == Right::anyone) return Identity{"", Role::observer};
    return unknown();
  }
  if (pattern.empty()) return std::move(*identity);  // who is known is told that there is no such route
  if (auto fine = check_right(*identity, pattern, right); !fine)
    return tl::unexpected(Denial{false, std::string(name(fine.error().code)), std::move(fine).error().message});
  return std::move(*identity);
}

bool Gate::is_current(const Identity& identity) const {
  if (identity.token == key_.identity().token) return true;
  return accounts_.is_current(identity, now_ms());
}

}  // namespace race::server
