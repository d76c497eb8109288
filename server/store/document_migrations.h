// How documents in race.sqlite (or documents.sqlite, as its file was called) of older versions of the program become
// what documents.h reads. Each runs in a transaction (services/sqlite/file.h).
#pragma once

namespace SQLite {
class Database;
}

namespace race::server {

/// Version 1: documents, each the text of its last revision. Those of a version of the program that gave no ids get
/// ids, also in place of a `meta.id` that is none, and today's form; they keep their revision, as nobody changed them.
/// What has other violations, or would be too large or too deep, stays as it is.
void give_document_ids(SQLite::Database& file);

/// Version 3: every revision of a document. The text that was stored is its first one and keeps its number.
void add_revisions(SQLite::Database& file);

}  // namespace race::server
