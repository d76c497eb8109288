// DocumentWatcher: who follows the documents as they change, such as what executes them.
//
// Threads: as said below.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace race::server {

class DocumentWatcher {
 public:
  virtual ~DocumentWatcher() = default;
  /// A document has a new revision, which is durable. On the thread that has stored it, in the order of its revisions;
  /// the next edit of this document waits meanwhile, so it must be quick, and must not call Editing.
  virtual void document_changed(const std::string& name, std::int64_t revision, bool has_violations) = 0;
  /// A document was removed, with all its revisions; the same holds. Who follows revisions alone does nothing.
  virtual void document_removed(const std::string& /*name*/) {}
};

/// Tells all that were added, in order. add() is to be called before the first document changes.
class DocumentWatchers final : public DocumentWatcher {
 public:
  /// `watcher` outlives this.
  void add(DocumentWatcher& watcher) { watchers_.push_back(&watcher); }

  void document_changed(const std::string& name, std::int64_t revision, bool has_violations) override {
    for (DocumentWatcher* watcher : watchers_) watcher->document_changed(name, revision, has_violations);
  }
  void document_removed(const std::string& name) override {
    for (DocumentWatcher* watcher : watchers_) watcher->document_removed(name);
  }

 private:
  std::vector<DocumentWatcher*> watchers_;
};

}  // namespace race::server
