// AuditLog: who has changed what, and when: every request and message that changes something, with the account, the
// address and the answer. Bodies are not in it: they may hold passwords, and documents and runs keep their own history.
//
// Each row is chained to the one before it (as journals are, server/store/journal_chain.h), so that one that is damaged
// or missing is named. The oldest go. Rows that the disk does not take wait, in their order, and are tried again.
//
// Threads: any; rows are written on a thread of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

struct AuditEntry {
  std::int64_t number = 0;  // from 1, without gaps; given by the log
  std::int64_t time = 0;    // [ms since 1970]
  std::string account;      // empty: the server had none
  std::string address;      // of the client
  std::string action;       // "POST /api/v1/cores/1/start", "edit pick"
  std::string outcome;      // status of the answer, "200"; of a message: "accepted", or an error's code
  bool operator==(const AuditEntry&) const = default;
};

class AuditLog {
 public:
  static constexpr std::int64_t kMost = 100'000;            // rows
  static constexpr std::size_t kLongest = 300;              // bytes of an action; what follows is cut off
  static constexpr std::size_t kMostWaiting = 10'000;       // rows that wait for the disk
  static constexpr std::chrono::milliseconds kRetry{1000};  // after a disk that has failed

  using Failed = std::function<void(const Error&)>;
  /// Opens the file (DataFolder::audit), and checks the chain of its rows; `failed` is told why rows cannot be written,
  /// once until they can, and how many are lost at the end. Errors: `corrupt`, `version`, `storage`, `io`.
  static Expected<std::unique_ptr<AuditLog>> open(const std::string& path, Failed failed);
  ~AuditLog();
  /// Writes what waits, or gives it up if the disk fails once more; what comes later is dropped.
  void close() EXCLUDES(queue_mutex_);

  /// Whether append() can be called: if not, what would be logged must not be done.
  bool has_room() const EXCLUDES(queue_mutex_);
  std::size_t waiting() const EXCLUDES(queue_mutex_) {
    const services::MutexLock lock(queue_mutex_);
    return queue_.size() + writing_;
  }
  /// Durable soon: what comes while others are written is written together.
  void append(AuditEntry entry) EXCLUDES(queue_mutex_);

  struct Page {
    std::vector<AuditEntry> entries;   // the last first
    std::optional<std::int64_t> next;  // `before` of the next page
  };
  /// Up to `limit` rows before the row `before`. Errors: `corrupt`, `storage`, `io`.
  Expected<Page> list(std::optional<std::int64_t> before, std::int64_t limit) EXCLUDES(mutex_);

 private:
  AuditLog(std::unique_ptr<SQLite::Database> file, Failed failed);
  void write_queue() EXCLUDES(mutex_, queue_mutex_);
  /// Why not; nothing: they are durable.
  std::optional<Error> write(std::list<AuditEntry>& entries) EXCLUDES(mutex_);

  const Failed failed_;
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
  mutable services::Mutex queue_mutex_;
  std::list<AuditEntry> queue_ GUARDED_BY(queue_mutex_);
  std::size_t writing_ GUARDED_BY(queue_mutex_) = 0;  // rows that were taken out of it and are not durable yet
  bool at_work_ GUARDED_BY(queue_mutex_) = false;     // write_queue() is
  bool closed_ GUARDED_BY(queue_mutex_) = false;
  services::ConditionVariable closing_;
  Pool pool_{1, 0, "audit"};
};

}  // namespace race::server
