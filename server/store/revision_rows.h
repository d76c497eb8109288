// The rows of the tables `document` and `revision` (schema.h), each held against its digest: what is damaged or lost is
// an error `corrupt` that names document and revision.
//
// Threads: that of the connection. All throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/store/revision.h"
#include "server/store/revision_text.h"

namespace SQLite {
class Database;
}

namespace race::server {

/// Nothing if there is no document of this name.
Expected<std::optional<RevisionRange>> find_range(SQLite::Database& file, const std::string& name);

/// Requires that the document has this revision.
Expected<RevisionText> read_revision(SQLite::Database& file, const std::string& name, std::int64_t number);

/// Revisions `from` to `to`, the newest first. Requires that the document has them. Reads no texts.
Expected<std::vector<Revision>> list_revisions(SQLite::Database& file, const std::string& name, RevisionRange range);

struct DocumentHeads {
  std::vector<Revision> revisions;
  std::vector<Error> damaged;  // `corrupt`: of a document each
  std::string next;            // name of the last document if there are more after it; else empty
};
/// The last revisions of at most `most` documents with names after `after`, in order of name. Reads no texts.
DocumentHeads list_heads(SQLite::Database& file, const std::string& after, std::int64_t most);

std::int64_t count_documents(SQLite::Database& file);

/// Whether the server's demo is all that was ever stored under this name, as far as is known.
bool has_only_demo(SQLite::Database& file, const std::string& name);

/// Adds the revision, and with it the range of its document. `edit`: what made it of the one before, if that is its
/// origin. Requires a transaction, and that `first` is the document's first revision and revision.number its next one.
void add_revision(SQLite::Database& file, const RevisionText& revision, std::int64_t first,
                  const RevisionEdit* edit = nullptr);

}  // namespace race::server
