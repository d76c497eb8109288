#include "server/editing/document_session.h"

#include <utility>

#include "core/edit/difference.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/value/json.h"

namespace race::server {
namespace {

/// Nothing if it cannot be edited: its shape is wrong, or elements have no ids.
std::optional<edit::Tree> tree_of(const Value& json) {
  const rcm::Draft draft = rcm::read_draft(json);
  if (!draft.has_root || !draft.errors.empty()) return std::nullopt;
  auto tree = edit::Tree::read(draft.document);
  if (!tree) return std::nullopt;
  return std::move(*tree);
}

/// A stored edit again, after those before it.
bool replay(edit::History& history, const DocumentPast::Edit& stored, std::int64_t first) {
  const auto& [revision, edit] = stored;
  const std::string& author = revision.change.author;
  const auto of = static_cast<edit::Revision>(revision.origin.revision);
  const bool is_undo = revision.origin.kind == Origin::Kind::undo;
  if (!takes_back(revision.origin.kind) || revision.origin.revision <= first) {
    const auto applied = history.apply(author, history.revision(), edit.edit);
    return applied && (*applied)->edit == edit.edit;
  }
  // What was rejected then is rejected now, and left out.
  for (;;) {
    const auto taken = is_undo ? history.undo(author) : history.redo(author);
    if (taken) return (*taken)->of == of && (*taken)->edit == edit.edit;
    if (taken.error().error.code == ErrorCode::not_found && taken.error().error.path.empty()) return false;
  }
}

EditRefusal refused(Error error, EditRefusal::Of of = EditRefusal::Of::edit) { return {of, {std::move(error)}}; }

Origin origin_of(const edit::Accepted& accepted) {
  using Kind = edit::Accepted::Kind;
  if (accepted.kind == Kind::change) return {Origin::Kind::edit};
  return {accepted.kind == Kind::undo ? Origin::Kind::undo : Origin::Kind::redo, "",
          static_cast<std::int64_t>(accepted.of)};
}

}  // namespace

Checked<DocumentSession> DocumentSession::read(Documents& documents, const std::string& name) {
  auto past = documents.past(name, kPast);
  if (!past) return tl::unexpected(std::move(past).error());
  DocumentSession out(documents, past->last);
  out.history_ = rebuild(*past);
  if (!out.history_) {
    if (auto tree = tree_of(past->last.document))
      out.history_.emplace(std::move(*tree), static_cast<edit::Revision>(out.revision()), kHistory);
  }
  const auto tokens = documents.tokens(name, kTokens);
  if (!tokens) return tl::unexpected(std::vector<Error>{tokens.error()});
  for (const EditToken& token : *tokens) out.remember(token.author, token.request, token.revision);
  return out;
}

/// Nothing if there are no stored edits, or they do not lead to the document with its undos, as they were then.
std::optional<edit::History> DocumentSession::rebuild(const DocumentPast& past) {
  if (past.edits.empty()) return std::nullopt;
  const auto json = parse_json(past.first, JsonLimits{.keep_out_of_range = true});
  auto tree = json ? tree_of(*json) : std::nullopt;
  if (!tree) return std::nullopt;
  const std::int64_t first = past.last.revision.number - static_cast<std::int64_t>(past.edits.size());
  edit::History history(std::move(*tree), static_cast<edit::Revision>(first), kHistory);
  for (const DocumentPast::Edit& edit : past.edits)
    if (!replay(history, edit, first)) return std::nullopt;
  if (to_json(rcm::write_document(history.tree().document())) != to_json(past.last.document)) return std::nullopt;
  return history;
}

tl::expected<DocumentSession::EditResult, EditRefusal> DocumentSession::edit(const EditRequest& request,
                                                                             std::int64_t now_ms) {
  if (!request.token.empty()) {
    const auto known = revisions_.find({request.author, request.token});
    if (known != revisions_.end()) return find_again(known->second);
  }
  if (request.if_match && *request.if_match != static_cast<edit::Revision>(revision()))
    return tl::unexpected(
        refused({ErrorCode::conflict,
                 "the last revision is " + std::to_string(revision()) + ", by `" + last_.revision.change.author + "`",
                 "If-Match"},
                EditRefusal::Of::precondition));
  if (!history_) {
    EditRefusal refusal =
        refused({ErrorCode::conflict, "the shape of this draft is wrong; it can only be put as a whole"},
                EditRefusal::Of::document);
    refusal.errors.insert(refusal.errors.end(), last_.errors.begin(), last_.errors.end());
    return tl::unexpected(std::move(refusal));
  }
  auto accepted = execute(request);
  if (!accepted) {
    auto& [error, revision, author] = accepted.error();
    return tl::unexpected(
        EditRefusal{EditRefusal::Of::edit, {std::move(error)}, static_cast<std::int64_t>(revision), std::move(author)});
  }
  return store(**accepted, request, now_ms);
}

edit::History::Result DocumentSession::execute(const EditRequest& request) {
  edit::History& history = *history_;
  if (const auto* back = std::get_if<EditRequest::TakeBack>(&request.what))
    return *back == EditRequest::TakeBack::undo ? history.undo(request.author) : history.redo(request.author);
  if (const auto* compound = std::get_if<CompoundRequest>(&request.what)) {
    const std::string seed = last_.revision.document + "@" + std::to_string(revision() + 1);
    auto edit = make_edit(*compound, history.tree(), seed);
    if (!edit) return tl::unexpected(edit::Rejection{std::move(edit).error(), 0, ""});
    return history.apply(request.author, history.revision(), *edit);
  }
  const edit::Revision seen = request.revision.value_or(history.revision());
  if (seen > history.revision())
    return tl::unexpected(
        edit::Rejection{{ErrorCode::out_of_range, "there is no revision " + std::to_string(seen), "revision"}, 0, ""});
  return history.apply(request.author, seen, std::get<edit::Edit>(request.what));
}

tl::expected<DocumentSession::EditResult, EditRefusal> DocumentSession::store(const edit::Accepted& accepted,
                                                                              const EditRequest& request,
                                                                              std::int64_t now_ms) {
  is_lost_ = true;  // until the disk has it, the history is ahead
  const rcm::Document document = history_->tree().document();
  auto text = rcm::write_document_text(document);
  if (!text) return tl::unexpected(refused(std::move(text).error()));
  DocumentEntry next{{}, Value(), rcm::violations(document, checks_)};
  next.revision = {last_.revision.document,
                   revision() + 1,
                   {request.author, request.message, now_ms},
                   origin_of(accepted),
                   static_cast<std::int64_t>(next.errors.size()),
                   doc_of(document)};
  const DocumentPast::Edit stored{next.revision, {accepted.edit, request.token}};
  if (auto done = documents_->append_edit({next.revision, std::move(*text)}, stored.edit); !done)
    return tl::unexpected(refused(std::move(done).error(), EditRefusal::Of::document));
  is_lost_ = false;
  last_ = std::move(next);
  remember(request.author, request.token, revision());
  return EditResult{accepted_edit_json(stored, last_.errors, depths(request.author))};
}

tl::expected<DocumentSession::EditResult, EditRefusal> DocumentSession::find_again(std::int64_t revision) {
  const std::string& name = last_.revision.document;
  auto entry = documents_->entry(name, revision);
  if (!entry) return tl::unexpected(EditRefusal{EditRefusal::Of::document, std::move(entry).error()});
  auto edit = documents_->edit_of(name, revision);
  if (!edit) return tl::unexpected(refused(std::move(edit).error(), EditRefusal::Of::document));
  const std::string author = entry->revision.change.author;
  return EditResult{accepted_edit_json({std::move(entry->revision), std::move(*edit)}, entry->errors, depths(author)),
                    true};
}

std::optional<Value> DocumentSession::replace(const DocumentEntry& entry) {
  const Change& change = entry.revision.change;
  auto tree = tree_of(entry.document);
  const auto number = static_cast<edit::Revision>(entry.revision.number);
  const bool follows = history_ && tree && history_->revision() + 1 == number;
  last_ = entry;
  if (follows) {
    auto difference = edit::difference(history_->tree(), *tree);
    if (difference) {
      if (const auto accepted = history_->apply(change.author, history_->revision(), std::move(*difference)))
        return accepted_edit_json({entry.revision, {(*accepted)->edit}}, entry.errors, depths(change.author));
    }
  }
  history_.reset();
  if (tree) history_.emplace(std::move(*tree), number, kHistory);
  return std::nullopt;
}

Value DocumentSession::snapshot() const {
  if (!last_.document.is_null() || !history_) return document_snapshot_json(last_);
  return document_snapshot_json({last_.revision, rcm::write_document(history_->tree().document()), last_.errors});
}

void DocumentSession::remember(const std::string& author, const std::string& token, std::int64_t revision) {
  if (token.empty()) return;
  tokens_.emplace_back(author, token);
  revisions_[tokens_.back()] = revision;
  if (tokens_.size() <= kTokens) return;
  revisions_.erase(tokens_.front());
  tokens_.pop_front();
}

EditDepths DocumentSession::depths(const std::string& author) const {
  if (!history_) return {};
  return {history_->undo_depth(author), history_->redo_depth(author)};
}

}  // namespace race::server
