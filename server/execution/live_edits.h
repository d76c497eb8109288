// LiveEdits: brings the revisions of documents to the cores that follow them, on a thread of its own, as that compiles
// them. What comes while it is busy is one revision, the last.
//
// Threads: any.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "server/editing/document_watcher.h"
#include "server/execution/cores.h"
#include "server/store/documents.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class LiveEdits final : public DocumentWatcher {
 public:
  /// Both outlive this.
  LiveEdits(Documents& documents, Cores& cores) : documents_(documents), cores_(cores) {}

  /// The document has another revision, or a core begins to follow it.
  void changed(const std::string& document) EXCLUDES(mutex_);
  void document_changed(const std::string& name, std::int64_t, bool) override { changed(name); }
  /// No more is brought, and what was on its way has been: the cores may end then. Not on the thread that brings.
  void close() EXCLUDES(mutex_);

 private:
  void bring_all() EXCLUDES(mutex_);
  std::optional<std::string> next() EXCLUDES(mutex_);
  void bring(const std::string& document);
  void bring(const std::shared_ptr<Core>& core, const StoredDocument& stored);

  Documents& documents_;
  Cores& cores_;
  services::Mutex mutex_;
  std::set<std::string> changed_ GUARDED_BY(mutex_);
  bool busy_ GUARDED_BY(mutex_) = false, closed_ GUARDED_BY(mutex_) = false;
  Pool pool_{1, 0, "live edits"};
};

}  // namespace race::server
