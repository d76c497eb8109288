#include "services/database/schema.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <array>
#include <string>

#include "services/sqlite/table_hash.h"

namespace race::database {
namespace {

// 1: values as JSON. Files that older versions of the program made say 0 and have it already.
void make_entries(SQLite::Database& file) {
  file.exec("CREATE TABLE IF NOT EXISTS entry (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID");
}

// 2: each with its digest, all with a hash of the table.
void add_digests(SQLite::Database& file) {
  sqlite::make_table_hashes(file);
  file.exec("CREATE TABLE record (key TEXT PRIMARY KEY, value TEXT NOT NULL, digest BLOB NOT NULL) WITHOUT ROWID");
  sqlite::TableHash hash;
  SQLite::Statement select(file, "SELECT key, value FROM entry");
  SQLite::Statement insert(file, "INSERT INTO record VALUES (?, ?, ?)");
  while (select.executeStep()) {
    const std::string key = select.getColumn(0), value = select.getColumn(1);
    const sqlite::Digest digest = digest_of(key, value);
    insert.reset();
    insert.bind(1, key);
    insert.bind(2, value);
    insert.bind(3, digest.data(), static_cast<int>(digest.size()));
    insert.exec();
    hash.insert(digest);
  }
  select.reset();
  file.exec("DROP TABLE entry");
  hash.write(file, kRecords);
  sqlite::keep_schema(file);
}

constexpr std::array<sqlite::Migration, 2> kMigrations = {make_entries, add_digests};

}  // namespace

std::span<const sqlite::Migration> migrations() { return kMigrations; }

}  // namespace race::database
