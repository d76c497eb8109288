// Removal of a document: its row goes first, and with it the document; its revisions follow in short transactions, as
// the journals of runs wait for each. The table `removed_document` keeps the last number of each removed document, so
// that a document of the same name goes on after it: no number of a revision means two texts.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>

#include "core/value/expected.h"

namespace SQLite {
class Database;
}

namespace race::server {

/// How many names of removed documents are kept; those that were removed first are forgotten, with their numbers.
inline constexpr std::int64_t kMostRemoved = 10'000;
/// How many revisions are removed in one transaction.
inline constexpr std::int64_t kRevisionsAtOnce = 200;

/// The last revision that a removed document of this name has had; 0: none was removed. Error `corrupt`.
Expected<std::int64_t> last_removed(SQLite::Database& file, const std::string& name);
/// The document is there no more, nor are breakpoints at it; its revisions up to `last` are to be removed. Requires a
/// transaction.
void begin_removal(SQLite::Database& file, const std::string& name, std::int64_t last);
/// The largest number of a revision that is stored under this name; 0: there is none.
std::int64_t largest_number(SQLite::Database& file, const std::string& name);
/// Removes some revisions of a removed document, in a transaction of its own. False: nothing is left of it.
bool remove_some(SQLite::Database& file, const std::string& name);
/// Finishes the removals of a server that ended meanwhile.
void finish_document_removals(SQLite::Database& file);

}  // namespace race::server
