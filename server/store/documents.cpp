#include "server/store/documents.h"

#include <SQLiteCpp/Database.h>

#include <algorithm>

#include "core/language/primitives/utf8.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "server/store/document_removal.h"
#include "server/store/edit_between.h"
#include "server/store/proposal_rows.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

tl::unexpected<std::vector<Error>> failed(Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); }

template <typename T>
Checked<T> checked(Expected<T> value) {
  if (!value) return failed(std::move(value).error());
  return std::move(*value);
}

tl::unexpected<std::vector<Error>> failure(const std::string& what, const SQLite::Exception& exception) {
  return failed(sqlite::error_of(exception, what));
}

constexpr const char* kCannotRead = "cannot read documents";

Expected<void> check_name(const std::string& name, const std::string& path) {
  if (rcm::is_id(name)) return {};
  return unexpected(ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", path);
}

Expected<void> check_length(const std::string& text, std::size_t most, const char* path) {
  if (language::utf8::length(text) <= most) return {};
  return unexpected(ErrorCode::too_large, "has more than " + std::to_string(most) + " characters", path);
}

Expected<void> check(const Change& change) {
  if (auto fits = check_length(change.author, Documents::kMaxAuthor, "author"); !fits) return fits;
  return check_length(change.message, Documents::kMaxMessage, "message");
}

ProposalDecision acceptance(const Change& by, std::int64_t revision) {
  return {Proposal::Status::accepted, by.author, "", by.time_ms, revision};
}

tl::unexpected<Error> no_document(const std::string& name) {
  return unexpected(ErrorCode::not_found, "there is no document of this name", name);
}

tl::unexpected<Error> another_revision(const std::string& name) {
  return unexpected(ErrorCode::conflict, "somebody else has stored another revision", name);
}

Checked<DocumentEntry> read(const RevisionText& stored) {
  auto document = read_document_or_draft(stored.text);
  if (!document) return tl::unexpected(std::move(document).error());
  return DocumentEntry{stored.revision, std::move(document->json), std::move(document->errors)};
}

}  // namespace

Documents::Documents(std::unique_ptr<SQLite::Database> file, Limits limits) : limits_(limits), file_(std::move(file)) {}
Documents::~Documents() = default;

Expected<std::unique_ptr<Documents>> Documents::open(const std::string& path, Limits limits) try {
  std::unique_ptr<Documents> documents(new Documents(sqlite::open(path), limits));
  documents->finish_removals_of_documents();
  return documents;
} catch (const SQLite::Exception& exception) {
  Error error = sqlite::error_of(exception, "cannot open the store");
  return unexpected(error.code, std::move(error.message), path);
}

Expected<DocumentHeads> Documents::heads(const std::string& after, std::int64_t most) try {
  const services::MutexLock lock(mutex_);
  return list_heads(*file_, after, most);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotRead));
}

Checked<std::vector<Revision>> Documents::list() {
  auto found = heads();
  if (!found) return failed(std::move(found).error());
  if (!found->damaged.empty()) return failed(std::move(found->damaged.front()));
  return std::move(found->revisions);
}

Checked<StoredDocument> Documents::get(const std::string& name, std::optional<std::int64_t> revision) try {
  const services::MutexLock lock(mutex_);
  const auto found = find(name, revision);
  if (!found) return failed(found.error());
  auto document = rcm::read_document_text(found->text);
  if (!document) return tl::unexpected(std::move(document).error());
  return StoredDocument{name, found->revision.number, std::move(*document)};
} catch (const SQLite::Exception& exception) {
  return failure(kCannotRead, exception);
}

Checked<DocumentEntry> Documents::entry(const std::string& name, std::optional<std::int64_t> revision) try {
  const services::MutexLock lock(mutex_);
  const auto found = find(name, revision);
  if (!found) return failed(found.error());
  return read(*found);
} catch (const SQLite::Exception& exception) {
  return failure(kCannotRead, exception);
}

Checked<std::vector<Revision>> Documents::revisions(const std::string& name, std::optional<std::int64_t> before,
                                                    std::int64_t most) try {
  const services::MutexLock lock(mutex_);
  const auto range = find_range(*file_, name);
  if (!range) return failed(range.error());
  if (!*range) return failed(no_document(name).value());
  const auto [first, last] = **range;
  const std::int64_t to = before ? std::min(last, std::max(*before, first) - 1) : last;
  return checked(list_revisions(*file_, name, {std::max(first, to - most + 1), to}));
} catch (const SQLite::Exception& exception) {
  return failure(kCannotRead, exception);
}

Checked<DocumentEntry> Documents::put(const std::string& name, std::string_view text, const Change& change,
                                      Put options) try {
  if (auto fits = check_name(name, name); !fits) return failed(std::move(fits).error());
  if (auto fits = check(change); !fits) return failed(std::move(fits).error());
  auto document = read_document_or_draft(text);
  if (!document) return tl::unexpected(std::move(document).error());
  if (!options.draft && !document->errors.empty()) return tl::unexpected(std::move(document->errors));
  const services::MutexLock lock(mutex_);
  return checked(put_next(name, text, *document, change, options));
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + name, exception);
}

Expected<DocumentEntry> Documents::put_next(const std::string& name, std::string_view text, DocumentText& document,
                                            const Change& change, const Put& options) {
  ASSIGN_OR_RETURN(Next next, next_of(name, text, document, options));
  DocumentEntry out{{}, std::move(document.json), std::move(document.errors)};
  if (next.old && next.old->text == next.text) {
    out.revision = next.old->revision;
    return out;
  }
  const auto errors = static_cast<std::int64_t>(out.errors.size());
  ASSIGN_OR_RETURN(out.revision,
                   append({{name, 1, change, {}, errors, doc_of(document.document)}, std::move(next.text)}));
  out.is_new = !next.old;
  return out;
}

Expected<Documents::Next> Documents::next_of(const std::string& name, std::string_view text, DocumentText& document,
                                             const Put& options) {
  ASSIGN_OR_RETURN(auto old, head(name));
  if (options.is_new && old) return unexpected(ErrorCode::conflict, "there is a document of this name", name);
  if (options.seen && (!old || old->revision.number != *options.seen)) return another_revision(name);
  ASSIGN_OR_RETURN(std::string next, next_text(document, text, old ? old->text : ""));
  return Next{std::move(old), std::move(next)};
}

Checked<std::string> Documents::prepare(const std::string& name, std::string_view text, const Put& options) try {
  if (auto fits = check_name(name, name); !fits) return failed(std::move(fits).error());
  auto document = read_document_or_draft(text);
  if (!document) return tl::unexpected(std::move(document).error());
  if (!options.draft && !document->errors.empty()) return tl::unexpected(std::move(document->errors));
  const services::MutexLock lock(mutex_);
  auto next = next_of(name, text, *document, options);
  if (!next) return failed(std::move(next).error());
  return std::move(next->text);
} catch (const SQLite::Exception& exception) {
  return failure(kCannotRead, exception);
}

Checked<DocumentEntry> Documents::accept(std::int64_t proposal, const Change& change) try {
  if (auto fits = check(change); !fits) return failed(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  const auto proposed = read_proposal(*file_, proposal);
  if (!proposed) return failed(proposed.error());
  auto document = read_document_or_draft(proposed->text);
  if (!document) return tl::unexpected(std::move(document).error());
  if (!document->errors.empty()) return tl::unexpected(std::move(document->errors));
  return checked(put_proposed(*proposed, *document, change));
} catch (const SQLite::Exception& exception) {
  return failure("cannot accept proposal " + std::to_string(proposal), exception);
}

Expected<DocumentEntry> Documents::put_proposed(const ProposalText& proposed, DocumentText& document,
                                                const Change& change) {
  const Proposal& proposal = proposed.proposal;
  if (auto open = check_open(proposal); !open) return tl::unexpected(std::move(open).error());
  Put options;
  options.is_new = proposal.base == 0;
  if (proposal.base > 0) options.seen = proposal.base;
  ASSIGN_OR_RETURN(Next next, next_of(proposal.document, proposed.text, document, options));
  DocumentEntry out{{}, std::move(document.json), {}};
  if (next.old && next.old->text == next.text) {
    sqlite::WriteTransaction transaction(*file_);
    out.revision = std::move(next.old->revision);
    auto done = decide_proposal(*file_, proposal.id, acceptance(change, out.revision.number));
    if (!done) return tl::unexpected(std::move(done).error());
    transaction.commit();
    return out;
  }
  const Origin origin{Origin::Kind::proposal, "", proposal.id, proposal.author};
  const std::int64_t number = next.old ? next.old->revision.number + 1 : 1;
  RevisionText accepted{{proposal.document, number, change, origin, 0, doc_of(document.document)},
                        std::move(next.text)};
  const auto edit = next.old ? edit_between(*next.old, accepted) : std::nullopt;
  ASSIGN_OR_RETURN(out.revision, append(std::move(accepted), edit ? &*edit : nullptr, proposal.id));
  out.is_new = !next.old;
  return out;
}

Checked<DocumentEntry> Documents::restore(const std::string& name, std::int64_t revision, const Change& change,
                                          std::optional<std::int64_t> seen) try {
  if (auto fits = check(change); !fits) return failed(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  auto old = find(name, revision);
  if (!old) return failed(std::move(old).error());
  auto last = find(name, {});
  if (!last) return failed(std::move(last).error());
  if (seen && last->revision.number != *seen) return failed(another_revision(name).value());
  if (old->text == last->text) return read(*last);
  return append_copy(std::move(*old), name, {Origin::Kind::restore, "", revision}, change);
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + name, exception);
}

Checked<DocumentPast> Documents::past(const std::string& name, std::int64_t most) try {
  DocumentPast out;
  const auto last = find_past(name, most, out);
  if (!last) return failed(last.error());
  auto entry = read(*last);
  if (!entry) return tl::unexpected(std::move(entry).error());
  out.last = std::move(*entry);
  return out;
} catch (const SQLite::Exception& exception) {
  return failure(kCannotRead, exception);
}

Expected<RevisionText> Documents::find_past(const std::string& name, std::int64_t most, DocumentPast& out) {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(RevisionText last, find(name, {}));
  ASSIGN_OR_RETURN(const auto range, find_range(*file_, name));
  std::int64_t number = last.revision.number;
  for (; number > range->first && last.revision.number - number < most; --number) {
    auto revision = list_revisions(*file_, name, {number, number});
    if (!revision || !is_edit(revision->front().origin.kind)) break;
    auto edit = find_edit(*file_, name, number);
    if (!edit) break;
    out.edits.push_back({std::move(revision->front()), std::move(*edit)});
  }
  std::ranges::reverse(out.edits);
  auto first = read_revision(*file_, name, number);
  if (!first) out.edits.clear();
  out.first = first ? std::move(first->text) : last.text;
  return last;
}

Expected<std::vector<EditToken>> Documents::tokens(const std::string& name, std::int64_t most) try {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const auto range, find_range(*file_, name));
  return list_tokens(*file_, name, range ? range->first : 1, most);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotRead));
}

Expected<RevisionEdit> Documents::edit_of(const std::string& name, std::int64_t revision) try {
  const services::MutexLock lock(mutex_);
  return find_edit(*file_, name, revision);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotRead));
}

Expected<void> Documents::append_edit(RevisionText next, const RevisionEdit& edit) try {
  if (auto fits = check(next.revision.change); !fits) return fits;
  const services::MutexLock lock(mutex_);
  auto appended = append(std::move(next), &edit);
  if (!appended) return tl::unexpected(std::move(appended).error());
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store an edit"));
}

Checked<DocumentEntry> Documents::branch(const std::string& name, const Branch& branch, const Change& change) try {
  if (auto fits = check_name(branch.as, "as"); !fits) return failed(std::move(fits).error());
  if (auto fits = check(change); !fits) return failed(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  auto from = find(name, branch.revision);
  if (!from) return failed(std::move(from).error());
  const auto taken = find_range(*file_, branch.as);
  if (!taken) return failed(taken.error());
  if (*taken) return failed({ErrorCode::conflict, "there is a document of this name", "as"});
  const std::int64_t revision = from->revision.number;
  auto made = append_copy(std::move(*from), branch.as, {Origin::Kind::branch, name, revision}, change);
  if (made) made->is_new = true;
  return made;
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + branch.as, exception);
}

Checked<DocumentEntry> Documents::append_copy(RevisionText copy, const std::string& name, Origin origin,
                                              const Change& change) {
  auto entry = read(copy);
  if (!entry) return entry;
  copy.revision.document = name;
  copy.revision.change = change;
  copy.revision.origin = std::move(origin);
  copy.revision.errors = static_cast<std::int64_t>(entry->errors.size());
  auto appended = append(std::move(copy));
  if (!appended) return failed(std::move(appended).error());
  entry->revision = std::move(*appended);
  return entry;
}

Expected<std::optional<RevisionText>> Documents::head(const std::string& name) {
  ASSIGN_OR_RETURN(const auto range, find_range(*file_, name));
  if (!range) return std::nullopt;
  return read_revision(*file_, name, range->last);
}

Expected<RevisionText> Documents::find(const std::string& name, std::optional<std::int64_t> revision) {
  ASSIGN_OR_RETURN(const auto range, find_range(*file_, name));
  if (!range) return no_document(name);
  const std::int64_t number = revision.value_or(range->last);
  if (!range->contains(number))
    return unexpected(ErrorCode::not_found,
                      "it has revisions " + std::to_string(range->first) + " to " + std::to_string(range->last), name);
  return read_revision(*file_, name, number);
}

// Only this connection writes documents, so what was read before is still so; the transaction is short, as the journals
// of runs wait for it.
Expected<Revision> Documents::append(RevisionText next, const RevisionEdit* edit, std::optional<std::int64_t> accepts) {
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(const auto range, find_range(*file_, next.revision.document));
  if (!range && count_documents(*file_) >= limits_.documents)
    return unexpected(ErrorCode::too_large, "there are already " + std::to_string(limits_.documents) + " documents",
                      next.revision.document);
  if (range && range->count() >= limits_.revisions)
    return unexpected(ErrorCode::too_large, "it has already " + std::to_string(limits_.revisions) + " revisions",
                      next.revision.document);
  ASSIGN_OR_RETURN(const std::int64_t last,
                   range ? Expected<std::int64_t>(range->last) : last_removed(*file_, next.revision.document));
  const std::int64_t number = last + 1;
  if (edit && (!range || next.revision.number != number)) return another_revision(next.revision.document);
  next.revision.number = number;
  add_revision(*file_, next, range ? range->first : number, edit);
  if (accepts)
    if (auto done = decide_proposal(*file_, *accepts, acceptance(next.revision.change, number)); !done)
      return tl::unexpected(std::move(done).error());
  transaction.commit();
  return std::move(next.revision);
}

Expected<void> Documents::remove(const std::string& name, std::optional<std::int64_t> seen) try {
  if (auto begun = begin_removal_of(name, seen); !begun) return begun;
  try {
    while (remove_some_of(name)) {
    }
  } catch (const SQLite::Exception&) {  // the document is gone; the rest goes when the store is opened next
  }
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot remove " + name));
}

Expected<void> Documents::begin_removal_of(const std::string& name, std::optional<std::int64_t> seen) {
  const services::MutexLock lock(mutex_);
  const auto range = find_range(*file_, name);
  if (!range && (range.error().code != ErrorCode::corrupt || seen)) return tl::unexpected(range.error());
  if (range && !*range) return no_document(name);
  if (seen && (*range)->last != *seen) return another_revision(name);
  sqlite::WriteTransaction transaction(*file_);
  const std::int64_t known = std::max(range ? (*range)->last : 0, last_removed(*file_, name).value_or(0));
  begin_removal(*file_, name, std::max(known, largest_number(*file_, name)));
  transaction.commit();
  return {};
}

bool Documents::remove_some_of(const std::string& name) {
  const services::MutexLock lock(mutex_);
  return remove_some(*file_, name);
}

void Documents::finish_removals_of_documents() try {
  const services::MutexLock lock(mutex_);
  finish_document_removals(*file_);
} catch (const SQLite::Exception&) {  // such as a full disk: what is left harms nobody, and goes another time
}

}  // namespace race::server
