// HostFunctions: what stays in the server of a component that lives in a process of its own. A display, say, is told by
// its process what to show; the screens are the server's. A service without one has empty functions.
//
// Threads: `version` any, the others the group's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::remote {

struct HostFunctions {
  /// Answers a question of the process. An error: no component asks this, and the process is lost.
  std::function<Expected<Value>(const std::string& function, const Dict& arguments)> request = {};
  /// Counts what the process would want to know; when it has changed, the process is told to ask again.
  std::function<std::uint64_t()> version = {};
  /// A process comes or is lost: nothing of one before is left.
  std::function<void()> reset = {};
};

}  // namespace race::remote
