// Editing: the documents that are edited, each by its DocumentSession, and everything else that changes documents while
// the server runs: so whoever follows a document sees every change of it, in order, once it is durable.
//
// Threads: any. One at a time changes a document; who wants the same one waits a bounded time (Limits::turn).
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/editing/document_session.h"
#include "server/editing/document_watcher.h"
#include "services/mutex.h"

namespace race::server {

/// Who tells clients. Called in the order of the revisions of a document; must be quick. Values are frozen.
class EditPublisher {
 public:
  virtual ~EditPublisher() = default;
  /// schemas/accepted_edit.json
  virtual void edited(const std::string& document, Value accepted) = 0;
  /// The document is another one, and no edit leads there. schemas/stream_message.json, `document_snapshot`.
  virtual void replaced(const std::string& document, Value snapshot) = 0;
  /// The document as it is, for those who asked for it (Editing::publish_snapshot).
  virtual void shown(const std::string& document, Value snapshot) = 0;
  /// There is no such document (`not_found`), or it cannot be read: `errors` says why.
  virtual void ended(const std::string& document, std::vector<Error> errors) = 0;
  /// Any document may be another one. No document changes until this has returned.
  virtual void all_replaced() = 0;
};

class Editing {
 public:
  struct Limits {
    std::size_t sessions = 32;             // at once; that of the document that was used least recently ends
    std::chrono::milliseconds turn{5000};  // until one has a document for itself
  };

  /// All outlive this.
  Editing(Documents& documents, EditPublisher& publisher, DocumentWatcher& watcher, Limits limits);
  Editing(Documents& documents, EditPublisher& publisher, DocumentWatcher& watcher)
      : Editing(documents, publisher, watcher, Limits{}) {}

  // Errors of all: `unavailable`, others take long, or a backup is being brought back; those of Documents.

  /// Makes an edit of the document as it is now.
  tl::expected<DocumentSession::EditResult, EditRefusal> edit(const std::string& name, const EditRequest& request)
      EXCLUDES(mutex_);
  /// As Documents::put, accept, restore and branch.
  Checked<DocumentEntry> put(const std::string& name, std::string_view text, const Change& change,
                             Documents::Put options) EXCLUDES(mutex_);
  /// `name`: the document of the proposal.
  Checked<DocumentEntry> accept(const std::string& name, std::int64_t proposal, const Change& change) EXCLUDES(mutex_);
  Checked<DocumentEntry> restore(const std::string& name, std::int64_t revision, const Change& change,
                                 std::optional<std::int64_t> seen = {}) EXCLUDES(mutex_);
  Checked<DocumentEntry> branch(const std::string& name, const Documents::Branch& branch, const Change& change)
      EXCLUDES(mutex_);

  /// As Documents::remove. For who follows the document, it ends: `not_found`.
  Expected<void> remove(const std::string& name, std::optional<std::int64_t> seen = {}) EXCLUDES(mutex_);

  /// Publishes the document as it is now, between its edits. Error `unavailable`; else it is shown, or ended.
  Expected<void> publish_snapshot(const std::string& name) EXCLUDES(mutex_);

  /// While one lives, no document changes. At its end, all are read again.
  class Pause {
   public:
    explicit Pause(Editing& editing) : editing_(&editing) {}
    Pause(Pause&& other) noexcept : editing_(std::exchange(other.editing_, nullptr)) {}
    ~Pause();

   private:
    Editing* editing_;
  };
  /// Waits for the changes that are being made. Error `unavailable`: they take long.
  Expected<Pause> pause() EXCLUDES(mutex_);

  /// How many documents are kept.
  std::size_t sessions() const EXCLUDES(mutex_);

 private:
  struct Document {
    std::optional<DocumentSession> session;  // belongs to whoever has its lock
    std::int64_t last_known = 0;             // revision that was published last
    bool is_taken = false;
    std::size_t waiting = 0;
    std::uint64_t used = 0;
  };
  class DocumentLock;

  std::optional<DocumentLock> lock_document(const std::string& name) EXCLUDES(mutex_);
  void unlock(Document& document) EXCLUDES(mutex_);
  void forget_least_used() REQUIRES(mutex_);
  void resume() noexcept EXCLUDES(mutex_);
  /// The session, read if it is not there.
  Checked<DocumentSession*> open(Document& document, const std::string& name);
  using ChangeText = std::function<Checked<DocumentEntry>()>;
  Checked<DocumentEntry> change_text(const std::string& name, const Change& by, const ChangeText& change)
      EXCLUDES(mutex_);

  Documents& documents_;
  EditPublisher& publisher_;
  DocumentWatcher& watcher_;
  const Limits limits_;
  mutable services::Mutex mutex_;
  services::ConditionVariable changed_;  // a turn has ended, or the pause
  std::map<std::string, std::unique_ptr<Document>, std::less<>> open_ GUARDED_BY(mutex_);
  std::uint64_t uses_ GUARDED_BY(mutex_) = 0;
  std::size_t taken_ GUARDED_BY(mutex_) = 0;  // turns
  bool is_paused_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::server
