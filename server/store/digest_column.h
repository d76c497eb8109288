// Digests in the columns of rows: blobs of 32 bytes.
//
// Threads: those of the statement.
#pragma once

#include "services/sqlite/digest.h"

namespace SQLite {
class Statement;
}

namespace race::server {

/// Binds a digest to the parameter `index`, from 1. Throws SQLite::Exception.
void bind_digest(SQLite::Statement& statement, int index, const sqlite::Digest& digest);
/// The digest in a column, from 0; one that is no text's if the column holds something else.
sqlite::Digest digest_in(SQLite::Statement& row, int column);

}  // namespace race::server
