// Tasks: requests whose work goes on after their answer, for clients that prefer that (Prefer: respond-async, RFC
// 7240). What each comes to is kept while the server runs; the oldest that are over go.
//
// Threads: any.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/http/message.h"
#include "services/mutex.h"

namespace race::server {

class Tasks {
 public:
  static constexpr std::size_t kMost = 100;              // that are kept
  static constexpr std::size_t kMostRunning = 16;        // of these
  static constexpr std::size_t kMostBytes = 32U << 20U;  // of the bodies of those; and of what others have come to

  /// Whether who sends it prefers to be answered before the work is done.
  static bool is_preferred(const Request& request);
  /// Makes a task of a request: schemas/task.json. `can_be_stopped`: its work looks at `request.gone`. Error
  /// `unavailable`: kMostRunning are being worked on, or their bodies would be larger than kMostBytes.
  Expected<Value> begin(const Request& request, bool can_be_stopped) EXCLUDES(mutex_);
  /// What its work has come to.
  void end(const std::string& id, const Reply& reply) EXCLUDES(mutex_);

  // For who has sent the request, and admins; for others there is none. schemas/task.json. Error `not_found`.

  Expected<Value> find(const std::string& id, const Identity& who) const EXCLUDES(mutex_);
  /// Its work is told to stop; it may be done all the same. `conflict`: it is over, or cannot be stopped.
  Expected<Value> cancel(const std::string& id, const Identity& who) EXCLUDES(mutex_);

 private:
  struct Task {
    std::string id;
    std::string account;
    std::string request;    // "POST /api/v1/backups"
    std::size_t bytes = 0;  // of its body; once it is over, of `reply`
    SharedStop stop = {};   // empty: it cannot be stopped
    SharedWorkProgress progress = {};
    bool cancelled = false;  // somebody has; `stop` is also set by work that takes too long
    std::optional<Reply> reply = {};

    bool is_done() const { return reply && reply->status < 400; }
  };
  static Value json(const Task& task);
  void forget_oldest() REQUIRES(mutex_);
  Expected<std::size_t> find_task(const std::string& id, const Identity& who) const REQUIRES(mutex_);

  mutable services::Mutex mutex_;
  std::deque<Task> tasks_ GUARDED_BY(mutex_);  // in order of their ids
  std::int64_t last_id_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::server
