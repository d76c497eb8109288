#include "server/accounts/accounts.h"

#include <algorithm>
#include <utility>

#include "core/language/primitives/utf8.h"
#include "server/accounts/secret.h"

namespace race::server {
namespace {

bool can_log_in_as_admin(const Account& account) {
  return account.role == Role::admin && !account.password_hash.empty();
}

bool has_expired(const AccountToken& token, std::int64_t now) { return token.expires != 0 && token.expires <= now; }

tl::unexpected<Error> no_account(std::string_view name) {
  return unexpected(ErrorCode::not_found, "there is no account of this name", std::string(name));
}

tl::unexpected<Error> another_password() {
  return unexpected(ErrorCode::conflict, "the account has another password by now", "password");
}

// Those of the account's tokens that make way for another one: the expired, and the oldest login for one too many.
// Error `too_large`.
Expected<std::vector<AccountToken>> ended_for(const AccountToken& wanted, const std::vector<AccountToken>& tokens) {
  const bool is_login = wanted.label == Accounts::kLogin;
  std::vector<AccountToken> ended;
  std::size_t alike = 0;  // logins, or all others
  const AccountToken* oldest = nullptr;
  for (const AccountToken& token : tokens) {
    if (has_expired(token, wanted.created)) {
      ended.push_back(token);
    } else if ((token.label == Accounts::kLogin) == is_login) {
      ++alike;
      if (!oldest || token.created < oldest->created) oldest = &token;
    }
  }
  if (alike < Accounts::kMostTokens) return ended;
  if (!is_login)
    return unexpected(ErrorCode::too_large,
                      "an account has at most " + std::to_string(Accounts::kMostTokens) + " tokens");
  ended.push_back(*oldest);
  return ended;
}

}  // namespace

Expected<std::unique_ptr<Accounts>> Accounts::open(const std::string& path) {
  ASSIGN_OR_RETURN(auto file, AccountFile::open(path));
  ASSIGN_OR_RETURN(AccountFile::Content content, file->read());
  std::unique_ptr<Accounts> accounts(new Accounts(std::move(file)));
  const services::MutexLock lock(accounts->mutex_);
  for (Account& account : content.accounts) accounts->accounts_.emplace(account.name, account);
  for (AccountToken& token : content.tokens) accounts->tokens_.emplace(token.digest, token);
  return accounts;
}

bool Accounts::empty() const {
  const services::MutexLock lock(mutex_);
  return accounts_.empty();
}

std::vector<Account> Accounts::list() const {
  const services::MutexLock lock(mutex_);
  std::vector<Account> list;
  for (const auto& [name, account] : accounts_) list.push_back(account);
  return list;
}

std::optional<Account> Accounts::find(std::string_view name) const {
  const services::MutexLock lock(mutex_);
  const auto found = accounts_.find(name);
  if (found == accounts_.end()) return std::nullopt;
  return found->second;
}

Expected<void> Accounts::add(const Account& account) {
  if (auto fine = account.check(); !fine) return fine;
  const services::MutexLock change(changing_);
  {
    const services::MutexLock lock(mutex_);
    if (accounts_.empty() && !can_log_in_as_admin(account))
      return unexpected(ErrorCode::not_accepted, "the first account is an admin's, with a password", "role");
    if (accounts_.contains(account.name))
      return unexpected(ErrorCode::conflict, "there is an account of this name", "name");
    if (accounts_.size() >= kMost)
      return unexpected(ErrorCode::too_large, "there may be " + std::to_string(kMost) + " accounts");
  }
  if (auto stored = file_->add(account); !stored) return stored;
  const services::MutexLock lock(mutex_);
  accounts_.emplace(account.name, account);
  return {};
}

// Whether somebody can still administer when this account is `instead`, or is none.
Expected<void> Accounts::check_admin_is_left(const std::string& without, const Account* instead) const {
  if (instead && can_log_in_as_admin(*instead)) return {};
  const services::MutexLock lock(mutex_);
  for (const auto& [name, account] : accounts_)
    if (name != without && can_log_in_as_admin(account)) return {};
  return unexpected(ErrorCode::conflict, "no admin with a password would be left", without);
}

std::vector<AccountToken> Accounts::tokens_of(std::string_view account) const {
  std::vector<AccountToken> tokens;
  for (const auto& [digest, token] : tokens_)
    if (token.account == account) tokens.push_back(token);
  return tokens;
}

Expected<void> Accounts::change(const std::string& name, const Change& change) {
  const services::MutexLock changing(changing_);
  const auto before = find(name);
  if (!before) return no_account(name);
  if (change.old_password_hash && before->password_hash != *change.old_password_hash) return another_password();
  Account after = *before;
  if (change.role && (*change.role == Role::process) != (before->role == Role::process))
    return unexpected(ErrorCode::not_accepted, "a person does not become a process, nor a process a person", "role");
  if (change.role) after.role = *change.role;
  if (change.groups) after.groups = *change.groups;
  if (change.password_hash) after.password_hash = *change.password_hash;
  if (auto fine = after.check(); !fine) return fine;
  if (auto left = check_admin_is_left(name, &after); !left) return left;
  std::vector<AccountToken> ended;
  if (change.password_hash) {
    const services::MutexLock lock(mutex_);
    ended = tokens_of(name);
  }
  if (auto stored = file_->change(*before, after, ended); !stored) return stored;
  const services::MutexLock lock(mutex_);
  accounts_.insert_or_assign(name, after);
  for (const AccountToken& token : ended) tokens_.erase(token.digest);
  return {};
}

Expected<void> Accounts::remove(const std::string& name) {
  const services::MutexLock changing(changing_);
  const auto account = find(name);
  if (!account) return no_account(name);
  if (auto left = check_admin_is_left(name, nullptr); !left) return left;
  std::vector<AccountToken> tokens;
  {
    const services::MutexLock lock(mutex_);
    tokens = tokens_of(name);
  }
  if (auto stored = file_->remove(*account, tokens); !stored) return stored;
  const services::MutexLock lock(mutex_);
  accounts_.erase(name);
  for (const AccountToken& token : tokens) tokens_.erase(token.digest);
  return {};
}

Expected<Accounts::Issued> Accounts::issue(const std::string& account, const std::string& label, std::int64_t now,
                                           std::int64_t expires, const TokenScope& scope) {
  return issue_unless_changed({"", account, label, now, expires, scope}, {});
}

Expected<Accounts::Issued> Accounts::issue_login(const std::string& account, const std::string& password_hash,
                                                 std::int64_t now, std::int64_t expires) {
  return issue_unless_changed({"", account, std::string(kLogin), now, expires}, {.password_hash = &password_hash});
}

Expected<Accounts::Issued> Accounts::issue_for(const Identity& by, const std::string& label, std::int64_t now,
                                               std::int64_t expires, const TokenScope& scope) {
  return issue_unless_changed({"", by.account, label, now, expires, scope}, {.identity = &by});
}

Expected<void> Accounts::check_unchanged(const AccountToken& wanted, const Condition& condition) const {
  const auto found = accounts_.find(wanted.account);
  if (found == accounts_.end()) return no_account(wanted.account);
  if (condition.password_hash && found->second.password_hash != *condition.password_hash) return another_password();
  if (condition.identity && !is_known(*condition.identity, wanted.created))
    return unexpected(ErrorCode::conflict, "who wanted the token is another one by now");
  return wanted.scope.check(found->second);
}

// `wanted` has no digest yet. Passwords and roles change under the same lock: none does between the look and the token.
Expected<Accounts::Issued> Accounts::issue_unless_changed(AccountToken wanted, const Condition& condition) {
  if (language::utf8::length(wanted.label) > AccountToken::kLongestLabel)
    return unexpected(ErrorCode::too_large,
                      "has more than " + std::to_string(AccountToken::kLongestLabel) + " characters", "label");
  const services::MutexLock changing(changing_);
  std::vector<AccountToken> tokens;
  {
    const services::MutexLock lock(mutex_);
    if (auto same = check_unchanged(wanted, condition); !same) return tl::unexpected(std::move(same).error());
    tokens = tokens_of(wanted.account);
  }
  ASSIGN_OR_RETURN(const std::vector<AccountToken> ended, ended_for(wanted, tokens));
  const std::string secret = make_secret(kTokenPrefix);
  wanted.digest = digest_of_secret(secret);
  if (auto stored = file_->exchange(ended, wanted); !stored) return tl::unexpected(std::move(stored).error());
  const services::MutexLock lock(mutex_);
  for (const AccountToken& old : ended) tokens_.erase(old.digest);
  tokens_.emplace(wanted.digest, wanted);
  return Issued{secret, wanted.digest};
}

std::vector<AccountToken> Accounts::tokens(std::string_view account, std::int64_t now) const {
  const services::MutexLock lock(mutex_);
  std::vector<AccountToken> tokens = tokens_of(account);
  std::erase_if(tokens, [&](const AccountToken& token) { return has_expired(token, now); });
  std::ranges::stable_sort(tokens, {}, &AccountToken::created);
  return tokens;
}

Expected<void> Accounts::revoke(const std::string& account, const std::string& digest) {
  const services::MutexLock changing(changing_);
  std::optional<AccountToken> token;
  {
    const services::MutexLock lock(mutex_);
    const auto found = tokens_.find(digest);
    if (found != tokens_.end() && found->second.account == account) token = found->second;
  }
  if (!token) return unexpected(ErrorCode::not_found, "the account has no such token", digest);
  if (auto stored = file_->remove(*token); !stored) return stored;
  const services::MutexLock lock(mutex_);
  tokens_.erase(digest);
  return {};
}

Identity Accounts::identity_of(const AccountToken& token) const {
  const Account& account = accounts_.find(token.account)->second;  // removed with its tokens
  Identity identity{account.name, account.role, account.groups, token.digest, ""};
  if (token.scope.role) identity.role = std::min(account.role, *token.scope.role);
  identity.display = token.scope.display;
  if (token.scope.local && !is_local(identity)) identity.groups.emplace_back(kLocal);
  return identity;
}

std::optional<Identity> Accounts::identify(std::string_view secret, std::int64_t now) const {
  const std::string digest = digest_of_secret(secret);
  const services::MutexLock lock(mutex_);
  const auto token = tokens_.find(digest);
  if (token == tokens_.end() || has_expired(token->second, now)) return std::nullopt;
  return identity_of(token->second);
}

bool Accounts::is_known(const Identity& identity, std::int64_t now) const {
  const auto token = tokens_.find(identity.token);
  if (token == tokens_.end() || has_expired(token->second, now)) return false;
  const Identity known = identity_of(token->second);
  return known.account == identity.account && known.role == identity.role && known.groups == identity.groups;
}

bool Accounts::is_current(const Identity& identity, std::int64_t now) const {
  const services::MutexLock lock(mutex_);
  return identity.account.empty() ? accounts_.empty() : is_known(identity, now);
}

}  // namespace race::server
