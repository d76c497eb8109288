// Documents: the tasks that the server keeps, by name, with every revision, in race.sqlite (schema.h). Drafts, which
// have violations, get in if they are asked for. A revision is never changed; the last one is the document as it is.
//
// What is damaged or lost is an error `corrupt` that names document and revision. Errors of all: `corrupt`; `storage`:
// the disk is full or fails, and nothing is changed; `io`.
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/store/document_text.h"
#include "server/store/proposal.h"
#include "server/store/revision.h"
#include "server/store/revision_rows.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

/// A document without violations.
struct StoredDocument {
  std::string name;
  std::int64_t revision = 1;
  rcm::Document document;
};

/// A document or a draft, as it is edited.
struct DocumentEntry {
  Revision revision;
  Value document;             // JSON
  std::vector<Error> errors;  // every violation, by the rules of this version of the program
  bool is_new = false;        // this revision has made the document
};

/// A document with the edits that have made it, as far as they reach back without another origin.
struct DocumentPast {
  struct Edit {
    Revision revision;
    RevisionEdit edit;
  };
  DocumentEntry last;
  std::vector<Edit> edits;  // the oldest first
  std::string first;        // the text before them
};

class Documents {
 public:
  /// How many there may be.
  struct Limits {
    std::int64_t documents = 10'000, revisions = 100'000;  // revisions: of one document
  };
  static constexpr std::size_t kMaxAuthor = 100, kMaxMessage = 1000;  // code points

  /// Opens the store. Requires that DataFolder has made it what this version reads.
  static Expected<std::unique_ptr<Documents>> open(const std::string& path, Limits limits);
  static Expected<std::unique_ptr<Documents>> open(const std::string& path) { return open(path, Limits{}); }
  ~Documents();

  /// The last revision of each, drafts among them, in order of name; those that are damaged are named beside them.
  Expected<DocumentHeads> heads() EXCLUDES(mutex_) { return heads("", limits_.documents); }
  /// The same of at most `most` with names after `after`.
  Expected<DocumentHeads> heads(const std::string& after, std::int64_t most) EXCLUDES(mutex_);
  /// The same, or an error if one is damaged.
  Checked<std::vector<Revision>> list() EXCLUDES(mutex_);
  /// A revision, else the last one, to be executed. `not_found`: there is none; every violation of a draft.
  Checked<StoredDocument> get(const std::string& name, std::optional<std::int64_t> revision = {}) EXCLUDES(mutex_);
  /// A revision, else the last one, to be edited. `not_found`: there is none; `json` and so on: what an older version
  /// of the program stored is no draft (document_text.h).
  Checked<DocumentEntry> entry(const std::string& name, std::optional<std::int64_t> revision = {}) EXCLUDES(mutex_);
  /// At most `most` revisions before revision `before` (nothing: from the last one on), the newest first. `not_found`.
  Checked<std::vector<Revision>> revisions(const std::string& name, std::optional<std::int64_t> before,
                                           std::int64_t most) EXCLUDES(mutex_);

  struct Put {
    bool draft = false;                // it may have violations
    std::optional<std::int64_t> seen;  // the last revision that the author knows of
    bool is_new = false;               // there is no document of this name
  };
  /// Stores a text as the next revision (document_text.h: next_text). A text that is the same then keeps its revision.
  /// Errors: every violation, unless it is a draft; `name`: not 1 to 64 of A-Z, a-z, 0-9, `_`, `-`; `too_large`,
  /// `too_deep`: with ids it could not be read again; `too_large`: of the change or the limits; `conflict`: the last
  /// revision is not `seen`, or there is one and it `is_new`.
  Checked<DocumentEntry> put(const std::string& name, std::string_view text, const Change& change, Put options)
      EXCLUDES(mutex_);
  Checked<DocumentEntry> put(const std::string& name, std::string_view text, const Change& change = {}) {
    return put(name, text, change, Put{});
  }
  /// The text that put() would store, which is not stored. Errors: those of put(), but those of its limits.
  Checked<std::string> prepare(const std::string& name, std::string_view text, const Put& options) EXCLUDES(mutex_);
  /// Stores an open proposal as the next revision of its document, and that it is accepted, both or neither. One that
  /// proposes the last text again keeps its revision. Errors: `not_found`; every violation, by today's rules;
  /// `conflict`: it was decided before, or its `base` is not the last revision; `too_large`.
  Checked<DocumentEntry> accept(std::int64_t proposal, const Change& change) EXCLUDES(mutex_);
  /// Makes the text of `revision` the next revision; that of the last one keeps its revision. `not_found`, `too_large`;
  /// `conflict`: the last revision is not `seen`; what entry() says of a text that is no draft.
  Checked<DocumentEntry> restore(const std::string& name, std::int64_t revision, const Change& change,
                                 std::optional<std::int64_t> seen = {}) EXCLUDES(mutex_);
  /// Removes a document, also a damaged one, with all its revisions; revisions of a document that gets its name go on
  /// after the last one. `not_found`; `conflict`: the last revision is not `seen`.
  Expected<void> remove(const std::string& name, std::optional<std::int64_t> seen = {}) EXCLUDES(mutex_);
  /// The last revision, with at most `most` edits that led to it; those before one that cannot be read are left out.
  /// Errors: those of entry().
  Checked<DocumentPast> past(const std::string& name, std::int64_t most) EXCLUDES(mutex_);
  /// As list_tokens (revision_text.h).
  Expected<std::vector<EditToken>> tokens(const std::string& name, std::int64_t most) EXCLUDES(mutex_);
  /// The edit that made a revision. Requires one that an edit made.
  Expected<RevisionEdit> edit_of(const std::string& name, std::int64_t revision) EXCLUDES(mutex_);
  /// Stores what an edit has made of the last revision; revision.number is the next one. Requires that `next.text` is
  /// the text of the last revision after the edit (core/edit). Errors: `conflict`: the document has another last
  /// revision; `too_large`.
  Expected<void> append_edit(RevisionText next, const RevisionEdit& edit) EXCLUDES(mutex_);
  struct Branch {
    std::string as;                        // name of the new document
    std::optional<std::int64_t> revision;  // else the last one
  };
  /// Makes a revision the first one of another document; elements keep their ids. `not_found`, `name`, `too_large`;
  /// `conflict`: there is a document of this name.
  Checked<DocumentEntry> branch(const std::string& name, const Branch& branch, const Change& change) EXCLUDES(mutex_);
  /// Puts every *.rcm.json of `folder` that is not there or that nobody has changed since it was put; none in place of
  /// a damaged document. Errors name the file.
  Checked<void> put_demo(const std::string& folder, std::int64_t now_ms);

 private:
  Documents(std::unique_ptr<SQLite::Database> file, Limits limits);
  Expected<void> begin_removal_of(const std::string& name, std::optional<std::int64_t> seen) EXCLUDES(mutex_);
  bool remove_some_of(const std::string& name) EXCLUDES(mutex_);
  void finish_removals_of_documents() EXCLUDES(mutex_);
  Expected<std::optional<RevisionText>> head(const std::string& name) REQUIRES(mutex_);
  Expected<RevisionText> find(const std::string& name, std::optional<std::int64_t> revision) REQUIRES(mutex_);
  Expected<RevisionText> find_past(const std::string& name, std::int64_t most, DocumentPast& out) EXCLUDES(mutex_);
  struct Next {
    std::optional<RevisionText> old;  // the last revision, if there is one
    std::string text;                 // of the next one
  };
  /// Errors: those of `options`, and of next_text (document_text.h).
  Expected<Next> next_of(const std::string& name, std::string_view text, DocumentText& document, const Put& options)
      REQUIRES(mutex_);
  Expected<DocumentEntry> put_proposed(const ProposalText& proposed, DocumentText& document, const Change& change)
      REQUIRES(mutex_);
  Expected<DocumentEntry> put_next(const std::string& name, std::string_view text, DocumentText& document,
                                   const Change& change, const Put& options) REQUIRES(mutex_);
  Checked<void> put_demo_file(const std::string& name, const std::string& path, std::int64_t now_ms) EXCLUDES(mutex_);
  /// A text as the next revision of `name`.
  Checked<DocumentEntry> append_copy(RevisionText copy, const std::string& name, Origin origin, const Change& change)
      REQUIRES(mutex_);
  /// After the last revision, or as the first one; the proposal `accepts` is decided with it. Errors: `too_large`;
  /// `conflict`: that was decided before.
  Expected<Revision> append(RevisionText next, const RevisionEdit* edit = nullptr,
                            std::optional<std::int64_t> accepts = {}) REQUIRES(mutex_);

  services::Mutex mutex_;
  const Limits limits_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
