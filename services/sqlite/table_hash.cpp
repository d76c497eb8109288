#include "services/sqlite/table_hash.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <string>

#include "services/sqlite/file.h"

namespace race::sqlite {
namespace {

constexpr std::string_view kSchema = "sqlite_schema";

void combine(Digest& sum, const Digest& row) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<unsigned char>(sum[i] ^ row[i]);
}

/// Of the row in which a hash is kept.
Digest digest_of(std::string_view table, const TableHash& hash) {
  return sha256_of({table, std::to_string(hash.rows), bytes(hash.sum)});
}

TableHash schema_of(SQLite::Database& file) {
  SQLite::Statement select(file, "SELECT type, name, tbl_name, coalesce(sql, '') FROM sqlite_schema");
  TableHash hash;
  while (select.executeStep()) {
    std::string fields[4];
    for (int i = 0; i < 4; ++i) fields[i] = select.getColumn(i).getString();
    hash.insert(sha256_of({fields[0], fields[1], fields[2], fields[3]}));
  }
  return hash;
}

}  // namespace

void TableHash::insert(const Digest& row) {
  ++rows;
  combine(sum, row);
}

void TableHash::remove(const Digest& row) {
  --rows;
  combine(sum, row);
}

Expected<TableHash> TableHash::read(SQLite::Database& file, std::string_view table) try {
  SQLite::Statement select(file, "SELECT rows, sum, digest FROM table_hash WHERE name = ?");
  select.bind(1, std::string(table));
  TableHash hash;
  if (!select.executeStep()) return hash;
  hash.rows = static_cast<std::uint64_t>(select.getColumn(0).getInt64());
  const std::string sum = select.getColumn(1).getString(), digest = select.getColumn(2).getString();
  if (sum.size() == hash.sum.size()) sum.copy(reinterpret_cast<char*>(hash.sum.data()), sum.size());
  if (sum.size() != hash.sum.size() || digest != bytes(digest_of(table, hash)))
    return unexpected(ErrorCode::corrupt, "the hash of the table `" + std::string(table) + "` is damaged");
  return hash;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot read the hash of the table `" + std::string(table) + "`"));
}

void TableHash::write(SQLite::Database& file, std::string_view table) const {
  const Digest digest = digest_of(table, *this);
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO table_hash VALUES (?, ?, ?, ?)");
  insert.bind(1, std::string(table));
  insert.bind(2, static_cast<std::int64_t>(rows));
  insert.bind(3, sum.data(), static_cast<int>(sum.size()));
  insert.bind(4, digest.data(), static_cast<int>(digest.size()));
  insert.exec();
}

void make_table_hashes(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE table_hash (name TEXT PRIMARY KEY, rows INTEGER NOT NULL, sum BLOB NOT NULL, digest BLOB NOT NULL)"
      " WITHOUT ROWID");
}

void keep_schema(SQLite::Database& file) { schema_of(file).write(file, kSchema); }

Expected<void> check_schema(SQLite::Database& file) try {
  ASSIGN_OR_RETURN(const TableHash kept, TableHash::read(file, kSchema));
  if (schema_of(file) == kept) return {};
  return unexpected(ErrorCode::corrupt, "the schema of the file is damaged", file.getFilename());
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot check " + file.getFilename()));
}

}  // namespace race::sqlite
