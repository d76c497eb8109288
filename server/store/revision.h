// Revision: a document as somebody stored it once: who, when, why, and where the text came from.
#pragma once

#include <cstdint>
#include <string>

#include "core/value/expected.h"

namespace race::server {

/// Where the text of a revision comes from.
struct Origin {
  enum class Kind {
    put,       // a client sent it
    restore,   // of `revision` of the same document
    branch,    // of `revision` of `document`
    demo,      // of the server's demo
    older,     // an older version of the program stored it, which kept no more than the text
    edit,      // an edit made it of the revision before
    undo,      // so did one that takes back the edit that made `revision`
    redo,      // so did one that takes back the undo that made `revision`
    proposal,  // `author` has proposed it, and who made the revision accepted it; `revision`: id of the proposal
  };
  Kind kind = Kind::put;
  std::string document = {};
  std::int64_t revision = 0;
  std::string author = {};
  bool operator==(const Origin&) const = default;
};

/// As routes and the store write it, such as "restore".
const char* name(Origin::Kind kind);
/// Whether it takes back what made another revision.
inline bool takes_back(Origin::Kind kind) { return kind == Origin::Kind::undo || kind == Origin::Kind::redo; }
/// Whether it is what an edit made of the revision before. That of an accepted proposal is one, where one leads there.
inline bool is_edit(Origin::Kind kind) {
  return kind == Origin::Kind::edit || kind == Origin::Kind::proposal || takes_back(kind);
}

/// Numbers of revisions of a document, without gaps.
struct RevisionRange {
  std::int64_t first = 1, last = 1;
  bool contains(std::int64_t number) const { return first <= number && number <= last; }
  std::int64_t count() const { return last - first + 1; }
};

/// Who changes a document, when, and why.
struct Change {
  std::string author = {};
  std::string message = {};
  std::int64_t time_ms = 0;  // since 1970; 0: not known
  bool operator==(const Change&) const = default;
};

/// A revision without its text.
struct Revision {
  std::string document = {};
  std::int64_t number = 1;
  Change change = {};
  Origin origin = {};
  std::int64_t errors = 0;  // violations, as they were counted when it was stored
  std::string doc = {};     // of the root, as doc_of (document_text.h)
  bool operator==(const Revision&) const = default;
};

struct RevisionText {
  Revision revision;
  std::string text;
};

/// `corrupt`, naming document and revision. `what`: "damaged", "lost".
tl::unexpected<Error> damaged_revision(const std::string& document, std::int64_t number, const char* what);

}  // namespace race::server
