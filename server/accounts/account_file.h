// AccountFile: accounts and tokens on the disk, in a file of their own: backups of documents and runs hold no
// passwords, and a restore brings back nobody who was removed. Only its owner may read it.
//
// Each row has the digest of its fields, and each table the hash of its rows (services/sqlite/table_hash.h): accounts
// that are damaged or lost are named when the file is opened, and never mean that there are none.
//
// Threads: one at a time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/accounts/account.h"

namespace SQLite {
class Database;
}

namespace race::server {

class AccountFile {
 public:
  struct Content {
    std::vector<Account> accounts;
    std::vector<AccountToken> tokens;
  };
  /// Makes the file if it is not there, and brings it to this version. Errors: `corrupt`, `version`, `storage`, `io`.
  static Expected<std::unique_ptr<AccountFile>> open(const std::string& path);
  ~AccountFile();

  /// All that it holds. Errors: `corrupt`, `storage`, `io`.
  Expected<Content> read();

  /// Each is durable when it returns. Requires that the row is not there, or is as given. Errors: `storage`, `io`,
  /// `corrupt`.
  Expected<void> add(const Account& account);
  /// Tokens `ended` make way for `token`.
  Expected<void> exchange(const std::vector<AccountToken>& ended, const AccountToken& token);
  Expected<void> remove(const AccountToken& token);
  /// Replaces `before`; its tokens `ended` go with it.
  Expected<void> change(const Account& before, const Account& after, const std::vector<AccountToken>& ended);
  /// Removes it with its tokens.
  Expected<void> remove(const Account& account, const std::vector<AccountToken>& tokens);

 private:
  explicit AccountFile(std::unique_ptr<SQLite::Database> file);
  const std::unique_ptr<SQLite::Database> file_;
};

}  // namespace race::server
