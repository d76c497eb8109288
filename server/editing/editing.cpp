#include "server/editing/editing.h"

#include <algorithm>
#include <utility>

#include "server/wire/calendar.h"
#include "services/failures.h"

namespace race::server {
namespace {

Error busy() { return {ErrorCode::unavailable, "others are changing this document; ask again"}; }

bool may_have_changed(const std::vector<Error>& errors) {
  return std::ranges::any_of(errors, [](const Error& error) {
    return error.code == ErrorCode::storage || error.code == ErrorCode::io || error.code == ErrorCode::corrupt;
  });
}

}  // namespace

/// While there is one, nobody else has the document.
class Editing::DocumentLock {
 public:
  DocumentLock(Editing& editing, Document& document) : editing_(&editing), document_(&document) {}
  DocumentLock(DocumentLock&& other) noexcept
      : editing_(std::exchange(other.editing_, nullptr)), document_(other.document_) {}
  ~DocumentLock() {
    if (editing_) editing_->unlock(*document_);
  }
  Document& document() const { return *document_; }

 private:
  Editing* editing_;
  Document* document_;
};

Editing::Editing(Documents& documents, EditPublisher& publisher, DocumentWatcher& watcher, Limits limits)
    : documents_(documents), publisher_(publisher), watcher_(watcher), limits_(limits) {}

std::optional<Editing::DocumentLock> Editing::lock_document(const std::string& name) {
  const services::MutexLock lock(mutex_);
  std::unique_ptr<Document>& slot = open_[name];
  if (!slot) slot = std::make_unique<Document>();
  Document& document = *slot;
  ++document.waiting;
  const bool is_free =
      changed_.wait_for(mutex_, limits_.turn, [&]() REQUIRES(mutex_) { return !is_paused_ && !document.is_taken; });
  --document.waiting;
  document.used = ++uses_;
  if (is_free) {
    document.is_taken = true;
    ++taken_;
  }
  forget_least_used();
  if (!is_free) return std::nullopt;
  return DocumentLock(*this, document);
}

void Editing::unlock(Document& document) {
  if (document.session && document.session->is_lost()) document.session.reset();
  {
    const services::MutexLock lock(mutex_);
    document.is_taken = false;
    --taken_;
    forget_least_used();
  }
  changed_.notify_all();
}

void Editing::forget_least_used() {
  while (open_.size() > limits_.sessions) {
    auto least = open_.end();
    for (auto each = open_.begin(); each != open_.end(); ++each) {
      if (each->second->is_taken || each->second->waiting > 0) continue;
      if (least == open_.end() || each->second->used < least->second->used) least = each;
    }
    if (least == open_.end()) return;
    open_.erase(least);
  }
}

Checked<DocumentSession*> Editing::open(Document& document, const std::string& name) {
  if (!document.session) {
    auto session = DocumentSession::read(documents_, name);
    if (!session) {
      const bool is_gone = session.error().front().code == ErrorCode::not_found;
      // A removal that was refused because the disk failed may have been stored all the same.
      if (is_gone && std::exchange(document.last_known, 0) > 0) {
        publisher_.ended(name, session.error());
        watcher_.document_removed(name);
      }
      return tl::unexpected(std::move(session).error());
    }
    document.session.emplace(std::move(*session));
    // What was refused because the disk failed may have been stored all the same.
    const std::int64_t revision = document.session->revision();
    if (document.last_known > 0 && document.last_known != revision) {
      publisher_.replaced(name, document.session->snapshot());
      watcher_.document_changed(name, revision, document.session->has_violations());
    }
    document.last_known = revision;
  }
  return &*document.session;
}

tl::expected<DocumentSession::EditResult, EditRefusal> Editing::edit(const std::string& name,
                                                                     const EditRequest& request) {
  auto lock = lock_document(name);
  if (!lock) return tl::unexpected(EditRefusal{EditRefusal::Of::document, {busy()}});
  Document& document = lock->document();
  const auto session = open(document, name);
  if (!session) return tl::unexpected(EditRefusal{EditRefusal::Of::document, session.error()});
  auto accepted = (*session)->edit(request, now_ms());
  if (!accepted || accepted->was_there) return accepted;
  document.last_known = (*session)->revision();
  publisher_.edited(name, accepted->edit);
  watcher_.document_changed(name, document.last_known, (*session)->has_violations());
  return accepted;
}

Checked<DocumentEntry> Editing::change_text(const std::string& name, const Change& by, const ChangeText& change) {
  auto lock = lock_document(name);
  if (!lock) return tl::unexpected(std::vector<Error>{busy()});
  Document& document = lock->document();
  auto stored = change();
  if (!stored) {
    if (may_have_changed(stored.error())) document.session.reset();
    return stored;
  }
  const std::int64_t revision = stored->revision.number;
  if (document.session && document.session->revision() == revision) return stored;
  if (stored->revision.change != by) return stored;  // the same text as before: it is that revision
  document.last_known = revision;
  auto edit = document.session ? document.session->replace(*stored) : std::nullopt;
  if (edit)
    publisher_.edited(name, std::move(*edit));
  else
    publisher_.replaced(name, document_snapshot_json(*stored));
  watcher_.document_changed(name, revision, !stored->errors.empty());
  return stored;
}

Checked<DocumentEntry> Editing::put(const std::string& name, std::string_view text, const Change& change,
                                    Documents::Put options) {
  return change_text(name, change, [&] { return documents_.put(name, text, change, options); });
}

Checked<DocumentEntry> Editing::accept(const std::string& name, std::int64_t proposal, const Change& change) {
  return change_text(name, change, [&] { return documents_.accept(proposal, change); });
}

Checked<DocumentEntry> Editing::restore(const std::string& name, std::int64_t revision, const Change& change,
                                        std::optional<std::int64_t> seen) {
  return change_text(name, change, [&] { return documents_.restore(name, revision, change, seen); });
}

Expected<void> Editing::remove(const std::string& name, std::optional<std::int64_t> seen) {
  auto lock = lock_document(name);
  if (!lock) return tl::unexpected(busy());
  auto removed = documents_.remove(name, seen);
  Document& document = lock->document();
  if (removed || may_have_changed({removed.error()})) document.session.reset();
  if (!removed) return removed;
  document.last_known = 0;
  publisher_.ended(name, {{ErrorCode::not_found, "the document was removed", name}});
  watcher_.document_removed(name);
  return {};
}

Checked<DocumentEntry> Editing::branch(const std::string& name, const Documents::Branch& branch, const Change& change) {
  return change_text(branch.as, change, [&] { return documents_.branch(name, branch, change); });
}

Expected<void> Editing::publish_snapshot(const std::string& name) {
  auto lock = lock_document(name);
  if (!lock) return tl::unexpected(busy());
  const auto session = open(lock->document(), name);
  if (session)
    publisher_.shown(name, (*session)->snapshot());
  else
    publisher_.ended(name, session.error());
  return {};
}

Expected<Editing::Pause> Editing::pause() {
  const services::MutexLock lock(mutex_);
  if (is_paused_) return tl::unexpected(busy());
  is_paused_ = true;
  const bool is_free = changed_.wait_for(mutex_, limits_.turn, [this]() REQUIRES(mutex_) { return taken_ == 0; });
  if (is_free) return Pause(*this);
  is_paused_ = false;
  changed_.notify_all();
  return tl::unexpected(busy());
}

Editing::Pause::~Pause() {
  if (editing_) editing_->resume();
}

// Subscribers are told before anybody changes a document: no edit of the new one follows what they have of the old one.
// Called by a destructor: what throws is reported, and documents change again all the same.
void Editing::resume() noexcept {
  services::run_reporting("telling that all documents may be others", [this] { publisher_.all_replaced(); });
  {
    const services::MutexLock lock(mutex_);
    for (auto& [name, document] : open_) {
      document->session.reset();
      document->last_known = 0;
    }
    is_paused_ = false;
  }
  changed_.notify_all();
}

std::size_t Editing::sessions() const {
  const services::MutexLock lock(mutex_);
  return open_.size();
}

}  // namespace race::server
