// Calls: the requests that are being worked on, by id: how many there are, and which are wanted no more.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/value/value.h"
#include "server/mcp/json_rpc.h"
#include "server/threads/stop.h"
#include "services/mutex.h"

namespace race::server::mcp {

class Calls {
 public:
  /// So many at once: those that wait for a thread are among them.
  static constexpr std::size_t kMost = 64;
  /// So many more, if they are calls that stop something.
  static constexpr std::size_t kMostStops = 4;

  /// A request begins; what is given becomes true when it is cancelled. Errors: `invalid_request`: one with this id is
  /// being worked on; `busy`: there are `most`.
  tl::expected<SharedStop, RpcError> begin(const Value& id, std::size_t most = kMost) EXCLUDES(mutex_);
  /// Its response is about to be written: the id is free again.
  void close(const Value& id) EXCLUDES(mutex_);
  /// Nothing more comes of it. To be called once after each close().
  void end() EXCLUDES(mutex_);

  /// If there is such a request.
  void cancel(const Value& id) EXCLUDES(mutex_);
  void cancel_all() EXCLUDES(mutex_);
  /// Waits until all have ended. False: some have not, in this time.
  bool wait_until_none(std::chrono::milliseconds time) EXCLUDES(mutex_);

 private:
  services::Mutex mutex_;
  services::ConditionVariable ended_;
  std::vector<std::pair<Value, SharedStop>> open_ GUARDED_BY(mutex_);
  std::size_t count_ GUARDED_BY(mutex_) = 0;  // that have not ended
};

}  // namespace race::server::mcp
