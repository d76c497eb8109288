// TableHash: a hash of all rows of a table, stored in the same file, with which a lost row is found: rows that are
// there have digests of their own. It is an incremental multiset hash (MSet-XOR-Hash: Clarke et al., "Incremental
// Multiset Hash Functions and Their Application to Memory Integrity Checking", Asiacrypt 2003) without a key: against
// damage, not against an opponent. A change of a row changes it in O(1).
//
// Use: a migration calls make_table_hashes(), and keep_schema() at its end. Each transaction that changes rows does
//
//   auto hash = TableHash::read(file, "document");    // error `corrupt`
//   hash->remove(old_digest); hash->insert(new_digest);
//   hash->write(file, "document");
//
// and who opens the file calls check_schema(), inserts the digests of all rows that it finds in a TableHash of its own,
// and compares that with what read() gives. Functions throw SQLite::Exception unless they return an Expected.
//
// Threads: any; a connection belongs to one at a time.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/value/expected.h"
#include "services/sqlite/digest.h"

namespace SQLite {
class Database;
}

namespace race::sqlite {

struct TableHash {
  std::uint64_t rows = 0;
  Digest sum = {};  // of the rows' digests, by exclusive or

  /// A row of this digest was added. A digest covers the key of its row, so that no two are equal.
  void insert(const Digest& row);
  /// Requires that it was added.
  void remove(const Digest& row);

  /// As stored for `table`; of none, that of no rows. Error `corrupt`: it is damaged itself; `storage`, `io`.
  static Expected<TableHash> read(SQLite::Database& file, std::string_view table);
  /// Stores it; in the transaction that changes the rows.
  void write(SQLite::Database& file, std::string_view table) const;

  bool operator==(const TableHash&) const = default;
};

/// Makes the table `table_hash`, which keeps them. In a migration.
void make_table_hashes(SQLite::Database& file);

/// Keeps the hash of the file's schema. At the end of a migration, after make_table_hashes().
void keep_schema(SQLite::Database& file);
/// Error `corrupt`: the schema is not the one that was kept: SQLite might find rows no more, or read them otherwise.
Expected<void> check_schema(SQLite::Database& file);

}  // namespace race::sqlite
