// DocumentSession: a document while it is edited: its history, whose revisions are those of the store, and the tokens
// of its last edits. What it says has happened is stored.
//
// One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "core/edit/history.h"
#include "core/rcm/code_checks.h"
#include "core/value/expected.h"
#include "server/editing/accepted_edit.h"
#include "server/editing/edit_request.h"
#include "server/store/documents.h"

namespace race::server {

class DocumentSession {
 public:
  static constexpr std::size_t kTokens = 1000;  // that are remembered
  static constexpr std::int64_t kPast = 256;    // stored edits that can be undone when a session begins
  static constexpr edit::HistoryLimits kHistory{.edits = 1000, .units = 4U << 20U};

  /// Reads the document as it is stored, with its last edits. Errors: those of Documents::entry.
  static Checked<DocumentSession> read(Documents& documents, const std::string& name);

  std::int64_t revision() const { return last_.revision.number; }
  /// schemas/stream_message.json, `document_snapshot`.
  Value snapshot() const;
  bool has_violations() const { return !last_.errors.empty(); }

  struct EditResult {
    Value edit;              // schemas/accepted_edit.json
    bool was_there = false;  // its token was that of an earlier edit, which this is
  };
  /// Makes the edit and stores it.
  tl::expected<EditResult, EditRefusal> edit(const EditRequest& request, std::int64_t now_ms);

  /// The document is stored as `entry`, whose text somebody has changed as a whole. The edit that this is; nothing if
  /// it is none: then the history begins anew.
  std::optional<Value> replace(const DocumentEntry& entry);

  /// What is stored may be another document than this: it must be read again.
  bool is_lost() const { return is_lost_; }

 private:
  DocumentSession(Documents& documents, DocumentEntry last) : documents_(&documents), last_(std::move(last)) {}
  static std::optional<edit::History> rebuild(const DocumentPast& past);
  edit::History::Result execute(const EditRequest& request);
  tl::expected<EditResult, EditRefusal> store(const edit::Accepted& accepted, const EditRequest& request,
                                              std::int64_t now_ms);
  tl::expected<EditResult, EditRefusal> find_again(std::int64_t revision);
  void remember(const std::string& author, const std::string& token, std::int64_t revision);
  EditDepths depths(const std::string& author) const;

  using Token = std::pair<std::string, std::string>;  // author, `request`

  Documents* documents_;
  DocumentEntry last_;                    // its document is null once it was edited: that is in the history
  rcm::CodeChecks checks_;                // of its revisions
  std::optional<edit::History> history_;  // nothing: it cannot be edited
  std::map<Token, std::int64_t> revisions_;
  std::deque<Token> tokens_;  // the oldest first
  bool is_lost_ = false;
};

}  // namespace race::server
