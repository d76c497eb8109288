// The texts of revisions that edits have made: stored as the edit that makes them of the revision before, where that is
// shorter, and whole at least every kLongestChain + 1 revisions, so that reading one takes a bounded number of edits.
// Each row of the table `revision_edit` (schema.h) is held against its digest, and the text that a chain gives against
// that of its revision: what is damaged or lost is an error `corrupt` that names the link.
//
// Threads: that of the connection. All throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/edit/operation.h"
#include "core/value/expected.h"
#include "server/store/revision.h"

namespace SQLite {
class Database;
}

namespace race::server {

/// What made a revision of the one before.
struct RevisionEdit {
  edit::Edit edit;
  std::string request = {};  // the token that its client chose; may be empty
};

/// What a client has called an edit that made a revision.
struct EditToken {
  std::string author, request;
  std::int64_t revision = 0;
  bool operator==(const EditToken&) const = default;
};

/// How many edits lead to a text from one that is stored whole, at most.
inline constexpr std::int64_t kLongestChain = 31;

/// Stores the edit that makes a revision, and says whether it is all that has to be stored: whether the text can be
/// left out. Requires a transaction, and that the revision before is stored and `next.text` is what the edit makes of
/// its text.
bool add_edit(SQLite::Database& file, const RevisionText& next, const RevisionEdit& edit);

/// How many edits lead to the text of a revision that is not stored whole: 1 to kLongestChain.
Expected<std::int64_t> chain_depth(SQLite::Database& file, const std::string& document, std::int64_t number);

/// The text of revision `links.last`: what the edits that made `links` make of `base`, the text of the one before.
Expected<std::string> text_after(SQLite::Database& file, const std::string& document, RevisionRange links,
                                 std::string_view base);

/// Those of the last `most` edits from revision `first` on that have one, the oldest first, whatever made the revisions
/// between them. What they say holds only if find_edit() and the revision say so, too: digests are not looked at.
std::vector<EditToken> list_tokens(SQLite::Database& file, const std::string& document, std::int64_t first,
                                   std::int64_t most);

/// The edit that made a revision.
Expected<RevisionEdit> find_edit(SQLite::Database& file, const std::string& document, std::int64_t number);

}  // namespace race::server
