#include "server/accounts/account_file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include "server/store/digest_column.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"
#include "services/sqlite/log_check.h"
#include "services/sqlite/table_hash.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;
using sqlite::Digest;
using sqlite::TableHash;

constexpr std::string_view kAccounts = "account", kTokens = "token";

// groups: names with a space between them; times: milliseconds since 1970.
void make_tables(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE account (name TEXT PRIMARY KEY, role TEXT NOT NULL, groups TEXT NOT NULL, hash TEXT NOT NULL,"
      " created INTEGER NOT NULL, digest BLOB NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE token (secret TEXT PRIMARY KEY, account TEXT NOT NULL, label TEXT NOT NULL,"
      " created INTEGER NOT NULL, expires INTEGER NOT NULL, digest BLOB NOT NULL) WITHOUT ROWID;");
  sqlite::make_table_hashes(file);
  sqlite::keep_schema(file);
}

// 2: tokens that may less than their account, and those of displays. role, display: empty: none. The digests of the
// tokens that are there stay (digest_of()): a damaged one is still found.
void add_scopes(SQLite::Database& file) {
  file.exec(
      "ALTER TABLE token ADD COLUMN role TEXT NOT NULL DEFAULT '';"
      "ALTER TABLE token ADD COLUMN local INTEGER NOT NULL DEFAULT 0;"
      "ALTER TABLE token ADD COLUMN display TEXT NOT NULL DEFAULT ''");
  sqlite::keep_schema(file);
}

constexpr std::array<sqlite::Migration, 2> kAccountMigrations = {make_tables, add_scopes};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    names.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return names;
}

Digest digest_of(const Account& account) {
  return sqlite::sha256_of({kAccounts, account.name, name(account.role), joined(account.groups), account.password_hash,
                            std::to_string(account.created)});
}

std::string role_text(const TokenScope& scope) { return scope.role ? std::string(name(*scope.role)) : ""; }

// One without a scope has the digest of version 1.
Digest digest_of(const AccountToken& token) {
  const std::string created = std::to_string(token.created), expires = std::to_string(token.expires);
  if (token.scope == TokenScope())
    return sqlite::sha256_of({kTokens, token.digest, token.account, token.label, created, expires});
  return sqlite::sha256_of({kTokens, token.digest, token.account, token.label, created, expires, role_text(token.scope),
                            token.scope.local ? "local" : "", token.scope.display});
}

tl::unexpected<Error> damaged(std::string_view what) {
  return unexpected(ErrorCode::corrupt, "the accounts are damaged", std::string(what));
}

Expected<Account> read_account(SQLite::Statement& row) {
  const auto role = role_of(row.getColumn(1).getString());
  if (!role) return damaged(kAccounts);
  Account account{row.getColumn(0).getString(), *role, split(row.getColumn(2).getString()),
                  row.getColumn(3).getString(), row.getColumn(4).getInt64()};
  if (digest_in(row, 5) != digest_of(account)) return damaged(kAccounts);
  return account;
}

Expected<AccountToken> read_token(SQLite::Statement& row) {
  AccountToken token{row.getColumn(0).getString(), row.getColumn(1).getString(), row.getColumn(2).getString(),
                     row.getColumn(3).getInt64(), row.getColumn(4).getInt64()};
  const std::string role = row.getColumn(6).getString();
  token.scope = {role_of(role), row.getColumn(7).getInt() != 0, row.getColumn(8).getString()};
  if (role != role_text(token.scope) || digest_in(row, 5) != digest_of(token)) return damaged(kTokens);
  return token;
}

// All rows of a table, none of which is lost.
template <typename Row>
Expected<std::vector<Row>> read_all(SQLite::Database& file, std::string_view table,
                                    Expected<Row> (*read)(SQLite::Statement&)) {
  ASSIGN_OR_RETURN(const TableHash kept, TableHash::read(file, table));
  SQLite::Statement select(file, "SELECT * FROM " + std::string(table));
  std::vector<Row> rows;
  TableHash found;
  while (select.executeStep()) {
    ASSIGN_OR_RETURN(Row row, read(select));
    found.insert(digest_of(row));
    rows.push_back(std::move(row));
  }
  if (!(found == kept)) return damaged(table);
  return rows;
}

void insert(SQLite::Database& file, const Account& account) {
  SQLite::Statement insert(file, "INSERT INTO account VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(1, account.name);
  insert.bind(2, std::string(name(account.role)));
  insert.bind(3, joined(account.groups));
  insert.bind(4, account.password_hash);
  insert.bind(5, account.created);
  bind_digest(insert, 6, digest_of(account));
  insert.exec();
}

void insert(SQLite::Database& file, const AccountToken& token) {
  SQLite::Statement insert(file, "INSERT INTO token VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, token.digest);
  insert.bind(2, token.account);
  insert.bind(3, token.label);
  insert.bind(4, token.created);
  insert.bind(5, token.expires);
  bind_digest(insert, 6, digest_of(token));
  insert.bind(7, role_text(token.scope));
  insert.bind(8, static_cast<int>(token.scope.local));
  insert.bind(9, token.scope.display);
  insert.exec();
}

void erase(SQLite::Database& file, const Account& account) {
  SQLite::Statement erase(file, "DELETE FROM account WHERE name = ?");
  erase.bind(1, account.name);
  erase.exec();
}

void erase(SQLite::Database& file, const AccountToken& token) {
  SQLite::Statement erase(file, "DELETE FROM token WHERE secret = ?");
  erase.bind(1, token.digest);
  erase.exec();
}

// What is removed from a table and added to it, in one transaction.
template <typename Row>
Expected<void> replace(SQLite::Database& file, std::string_view table, std::span<const Row> removed,
                       std::span<const Row> added) {
  ASSIGN_OR_RETURN(TableHash hash, TableHash::read(file, table));
  for (const Row& row : removed) {
    erase(file, row);
    hash.remove(digest_of(row));
  }
  for (const Row& row : added) {
    insert(file, row);
    hash.insert(digest_of(row));
  }
  hash.write(file, table);
  return {};
}

struct Changes {
  std::span<const Account> removed = {}, added = {};
  std::span<const AccountToken> removed_tokens = {}, added_tokens = {};
};

Expected<void> store(SQLite::Database& file, const Changes& changes) try {
  sqlite::WriteTransaction transaction(file);
  if (auto done = replace(file, kAccounts, changes.removed, changes.added); !done) return done;
  if (auto done = replace(file, kTokens, changes.removed_tokens, changes.added_tokens); !done) return done;
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store the accounts"));
}

// Before SQLite makes it, so that nobody reads it meanwhile; its log and index get the same permissions.
void keep_private(const std::string& path) {
  constexpr auto kOwner = fs::perms::owner_read | fs::perms::owner_write;
  const int made = ::open(path.c_str(), O_CREAT | O_CLOEXEC | O_RDWR, S_IRUSR | S_IWUSR);
  if (made >= 0) ::close(made);
  std::error_code ignored;
  fs::permissions(path, kOwner, ignored);
}

}  // namespace

AccountFile::AccountFile(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
AccountFile::~AccountFile() = default;

Expected<std::unique_ptr<AccountFile>> AccountFile::open(const std::string& path) try {
  if (auto sound = sqlite::check_log(path); !sound) return tl::unexpected(std::move(sound).error());
  keep_private(path);
  auto file = sqlite::open(path);
  if (auto migrated = sqlite::migrate(*file, kAccountMigrations); !migrated)
    return tl::unexpected(std::move(migrated).error());
  if (auto sound = sqlite::check(*file); !sound) return tl::unexpected(std::move(sound).error());
  if (auto sound = sqlite::check_schema(*file); !sound) return tl::unexpected(std::move(sound).error());
  return std::unique_ptr<AccountFile>(new AccountFile(std::move(file)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the accounts"));
}

Expected<AccountFile::Content> AccountFile::read() try {
  Content content;
  ASSIGN_OR_RETURN(content.accounts, read_all(*file_, kAccounts, read_account));
  ASSIGN_OR_RETURN(content.tokens, read_all(*file_, kTokens, read_token));
  return content;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read the accounts"));
}

Expected<void> AccountFile::add(const Account& account) { return store(*file_, {.added = {&account, 1}}); }
Expected<void> AccountFile::exchange(const std::vector<AccountToken>& ended, const AccountToken& token) {
  return store(*file_, {.removed_tokens = ended, .added_tokens = {&token, 1}});
}
Expected<void> AccountFile::remove(const AccountToken& token) { return store(*file_, {.removed_tokens = {&token, 1}}); }
Expected<void> AccountFile::change(const Account& before, const Account& after,
                                   const std::vector<AccountToken>& ended) {
  return store(*file_, {.removed = {&before, 1}, .added = {&after, 1}, .removed_tokens = ended});
}
Expected<void> AccountFile::remove(const Account& account, const std::vector<AccountToken>& tokens) {
  return store(*file_, {.removed = {&account, 1}, .removed_tokens = tokens});
}

}  // namespace race::server
