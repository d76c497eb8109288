#include "server/store/digest_column.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <cstring>

namespace race::server {

void bind_digest(SQLite::Statement& statement, int index, const sqlite::Digest& digest) {
  statement.bind(index, digest.data(), static_cast<int>(digest.size()));
}

sqlite::Digest digest_in(SQLite::Statement& row, int column) {
  const SQLite::Column blob = row.getColumn(column);
  sqlite::Digest digest = {};
  if (blob.getBytes() == static_cast<int>(digest.size())) std::memcpy(digest.data(), blob.getBlob(), digest.size());
  return digest;
}

}  // namespace race::server
