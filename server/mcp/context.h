// Context: what a request that is worked on has beside its parameters.
//
// Threads: that of the request.
#pragma once

#include <functional>
#include <string>

#include "server/mcp/api.h"
#include "server/threads/stop.h"

namespace race::server::mcp {

struct Context {
  const Api& api;
  /// True: nobody waits for the response; what takes long should end.
  const Stop& cancelled;
  /// Tells the client how far it is: `done`, which grows, of `total`. Does nothing if the client has not asked for it.
  std::function<void(double done, double total, const std::string& message)> tell_progress;
};

/// The most text of an answer, as JSON [bytes].
inline constexpr std::size_t kMostText = std::size_t{1024} * 1024;

}  // namespace race::server::mcp
