// HostFunctions: what stays in the server of a component that lives in a process of its own, and is called from there.
// The process of a display, say, decides what to show; the screens are connections of the server. A service that needs
// none has empty functions.
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
  /// Executes a call of the process. An error: no component makes it, and the process is disconnected.
  std::function<Expected<Value>(const std::string& function, const Dict& arguments)> request = {};
  /// Counts the changes that concern the process; it gets `news` after each, and calls again.
  std::function<std::uint64_t()> version = {};
  /// A process has connected or disconnected: takes away what the one before has left.
  std::function<void()> reset = {};
};

}  // namespace race::remote
