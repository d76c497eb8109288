// DocumentBreakpoints: the breakpoints that each person keeps at a document, by the name of the person, until the
// document is removed (document_removal.h).
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

class DocumentBreakpoints {
 public:
  /// Of the breakpoints of a person, of the people at a document, and of the name of a person [code points].
  static constexpr std::size_t kMost = 100, kMostPeople = 100, kLongestName = 100;

  /// Opens the store (DataFolder::store). Errors of all: `storage`, `io`.
  static Expected<std::unique_ptr<DocumentBreakpoints>> open(const std::string& path);
  ~DocumentBreakpoints();

  /// Whether this can be the name of a person. Errors, at `author`: `missing`, `too_large`.
  static Expected<void> check_author(const std::string& author);
  /// Empty if the person has none, or there is no such document. Errors: those of check_author(); `corrupt`:
  /// what was stored is damaged.
  Expected<List> get(const std::string& document, const std::string& author) EXCLUDES(mutex_);
  /// Replaces those of a person; durable when it returns. Where they are too many people, who has set theirs longest
  /// ago loses them. Errors: those of check_author(); `not_found`: there is no such document; `too_large`: more than
  /// kMost.
  Expected<void> set(const std::string& document, const std::string& author, const List& breakpoints) EXCLUDES(mutex_);

 private:
  explicit DocumentBreakpoints(std::unique_ptr<SQLite::Database> file);
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
