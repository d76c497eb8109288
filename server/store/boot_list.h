// BootList: what the server starts when it begins, in order: documents and the arguments of their runs.
//
// Threads: any; one at a time inside.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

struct BootEntry {
  std::string document;
  Dict arguments;
  bool operator==(const BootEntry&) const = default;
};

class BootList {
 public:
  static constexpr std::size_t kMost = 64;

  /// Opens the store (DataFolder::store). Error of all: `storage`, `io`.
  static Expected<std::unique_ptr<BootList>> open(const std::string& path);
  ~BootList();

  /// Error `corrupt`, naming the entry: what was stored is damaged.
  Expected<std::vector<BootEntry>> get() EXCLUDES(mutex_);
  /// Whether it can be set. Errors: `too_large` (more than kMost), `duplicate` (a document stands twice, at
  /// `entries/N/document`).
  static Expected<void> check(const std::vector<BootEntry>& entries);
  /// Replaces all entries; durable when it returns. Errors: those of check().
  Expected<void> set(const std::vector<BootEntry>& entries) EXCLUDES(mutex_);

 private:
  explicit BootList(std::unique_ptr<SQLite::Database> file);
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
