// Accounts: who may use the server, and the tokens by which they are known. All of it is in memory, so that asking
// waits for no disk; changes are durable when they return.
//
// A server without accounts is the demo: whoever can reach it, on this machine alone, may do everything. The first
// account is an admin's, and from then on everybody needs one; the last admin can be neither removed nor demoted.
//
// Threads: any. Changes wait for the disk, and for each other; questions wait for neither.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/accounts/account.h"
#include "server/accounts/account_file.h"
#include "services/mutex.h"

namespace race::server {

class Accounts {
 public:
  static constexpr std::size_t kMost = 200;
  static constexpr std::size_t kMostTokens = 100;  // of an account; as many logins, of which the oldest end

  /// Opens the file (DataFolder::accounts). Errors: those of AccountFile.
  static Expected<std::unique_ptr<Accounts>> open(const std::string& path);

  /// Whether there is none: the demo.
  bool empty() const EXCLUDES(mutex_);
  std::vector<Account> list() const EXCLUDES(mutex_);
  std::optional<Account> find(std::string_view name) const EXCLUDES(mutex_);

  /// Errors: those of Account::check(); `conflict`: the name is taken; `too_large` (kMost); `not_accepted`: the first
  /// is no admin with a password; those of AccountFile.
  Expected<void> add(const Account& account) EXCLUDES(changing_, mutex_);
  struct Change {
    std::optional<Role> role = {};
    std::optional<std::vector<std::string>> groups = {};
    std::optional<std::string> password_hash = {};
    std::optional<std::string> old_password_hash = {};  // that of the password that was shown for this change
  };
  /// A new password ends all tokens of the account. Errors: `not_found`; `conflict`: no admin who can log in would be
  /// left, or the old password is another one by now; `not_accepted`: a person would become a process, or a process a
  /// person; those of Account::check() and AccountFile.
  Expected<void> change(const std::string& name, const Change& change) EXCLUDES(changing_, mutex_);
  /// Removes it with its tokens. Errors: `not_found`, `conflict` (as of change), those of AccountFile.
  Expected<void> remove(const std::string& name) EXCLUDES(changing_, mutex_);

  /// A new token, which is known from then on until `expires` [ms since 1970; 0: for ever]. The secret is returned here
  /// and never again. Errors: `not_found`, `too_large` (the label; kMostTokens), those of TokenScope::check() and
  /// AccountFile.
  struct Issued {
    std::string secret, digest;
  };
  Expected<Issued> issue(const std::string& account, const std::string& label, std::int64_t now, std::int64_t expires,
                         const TokenScope& scope = {}) EXCLUDES(changing_, mutex_);
  /// The same for who has shown the password of this hash: a login. Error `conflict`: the account has another one by
  /// now, also if it is a new account of this name.
  Expected<Issued> issue_login(const std::string& account, const std::string& password_hash, std::int64_t now,
                               std::int64_t expires) EXCLUDES(changing_, mutex_);
  /// The same of the account of `by`, who wanted that before. Error `conflict`: they are no more who they were: their
  /// own token has ended, or their role or groups are others.
  Expected<Issued> issue_for(const Identity& by, const std::string& label, std::int64_t now, std::int64_t expires,
                             const TokenScope& scope) EXCLUDES(changing_, mutex_);
  /// Of the account, without those that have expired: the oldest first, and of one millisecond by their digests, which
  /// say nothing of which was first. After a restart in the same order.
  std::vector<AccountToken> tokens(std::string_view account, std::int64_t now) const EXCLUDES(mutex_);
  /// The account's token of this digest is known no more. Errors: `not_found`, those of AccountFile.
  Expected<void> revoke(const std::string& account, const std::string& digest) EXCLUDES(changing_, mutex_);

  /// Whose secret this is; nothing: nobody's, or it has expired.
  std::optional<Identity> identify(std::string_view secret, std::int64_t now) const EXCLUDES(mutex_);
  /// Whether what was identified once still is: the token, and the role and groups of its account. Of nobody in
  /// particular: whether there are still no accounts.
  bool is_current(const Identity& identity, std::int64_t now) const EXCLUDES(mutex_);

  static constexpr std::string_view kLogin = "login";  // the label of tokens that a password has brought

 private:
  explicit Accounts(std::unique_ptr<AccountFile> file) : file_(std::move(file)) {}
  std::vector<AccountToken> tokens_of(std::string_view account) const REQUIRES(mutex_);
  Expected<void> check_admin_is_left(const std::string& without, const Account* instead) const EXCLUDES(mutex_);
  /// What must still hold when a token is made; a nullptr is no condition.
  struct Condition {
    const std::string* password_hash = nullptr;
    const Identity* identity = nullptr;
  };
  Expected<Issued> issue_unless_changed(AccountToken wanted, const Condition& condition) EXCLUDES(changing_, mutex_);
  Expected<void> check_unchanged(const AccountToken& wanted, const Condition& condition) const REQUIRES(mutex_);
  Identity identity_of(const AccountToken& token) const REQUIRES(mutex_);
  bool is_known(const Identity& identity, std::int64_t now) const REQUIRES(mutex_);

  services::Mutex changing_;  // one change at a time, also while the disk is waited for
  const std::unique_ptr<AccountFile> file_ PT_GUARDED_BY(changing_);
  mutable services::Mutex mutex_;
  std::map<std::string, Account, std::less<>> accounts_ GUARDED_BY(mutex_);     // by name
  std::map<std::string, AccountToken, std::less<>> tokens_ GUARDED_BY(mutex_);  // by digest
};

}  // namespace race::server
