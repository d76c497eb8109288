// Batch: the responses of a JSON-RPC batch, which are sent together once the last is there (protocol 2025-03-26).
//
// Threads: any. Held by the requests of the batch.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "core/value/value.h"
#include "services/mutex.h"

namespace race::server::mcp {

/// Writes a message; on any thread.
using Send = std::function<void(const Value& message)>;
/// Gets the response of a request, once; nothing: it has none. On any thread.
using Respond = std::function<void(std::optional<Value> response)>;

class Batch {
 public:
  Batch(std::size_t messages, Send send) : waiting_(messages), send_(std::move(send)) {}

  void add(std::optional<Value> response) EXCLUDES(mutex_);

 private:
  services::Mutex mutex_;
  std::size_t waiting_ GUARDED_BY(mutex_);
  List responses_ GUARDED_BY(mutex_);
  const Send send_;
};

}  // namespace race::server::mcp
