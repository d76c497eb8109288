// EventLog: the last lines of the server's log, and the channel `log` of the stream (schemas/log_entry.json). Each line
// goes to the LineLog, too.
//
// Threads: any.
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <map>
#include <string>

#include "core/value/value.h"
#include "server/log/line_log.h"
#include "server/stream/hub.h"
#include "services/clock.h"
#include "services/mutex.h"

namespace race::server {

class EventLog {
 public:
  static constexpr std::size_t kMaxEntries = 200;
  static constexpr std::size_t kMaxText = 2000;  // bytes of a line; what follows the last whole character is cut off

  static constexpr std::size_t kMaxStatuses = 1024;  // more than there are cores; without one, a line may come twice

  /// The hub and `lines` outlive this; without `lines`, clients alone see the log.
  explicit EventLog(Hub& hub, LineLog* lines = nullptr) : hub_(hub), lines_(lines) {}

  /// Adds a line and publishes it. `source`: "server", "core/1", the key of a service. `level` is of the LineLog.
  void append(services::Time time, const std::string& source, const std::string& text, LogLevel level = LogLevel::info)
      EXCLUDES(mutex_);
  /// Adds a line on the status of a core (schemas/core.json: started, ended and how, faulted and where) if it differs
  /// from the status logged last. Returns whether it does.
  bool append_status(services::Time time, const std::string& core_id, const Value& core) EXCLUDES(mutex_);
  /// Drops the status of a core that has been removed.
  void drop_status(const std::string& core_id) EXCLUDES(mutex_);
  /// How many lines of this level there were.
  std::uint64_t lines(LogLevel level) const { return counts_.at(static_cast<std::size_t>(level)); }
  /// Publishes all lines as a snapshot of the channel.
  void publish_snapshot() const EXCLUDES(mutex_);

 private:
  Hub& hub_;
  LineLog* const lines_;
  std::array<std::atomic<std::uint64_t>, 4> counts_ = {};  // by level
  mutable services::Mutex mutex_;
  std::deque<Value> entries_ GUARDED_BY(mutex_);                    // schemas/log_entry.json
  std::map<std::string, std::string> statuses_ GUARDED_BY(mutex_);  // by core: as logged last
};

}  // namespace race::server
