// Cores of a running server as commands name and print them (api/openapi.yaml, /api/v1/cores).
#pragma once

#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

inline constexpr const char* kCores = "/api/v1/cores";

/// The path of a core in requests.
std::string core_path(const std::string& id);

/// A core (schemas/core.json) as a line, without its end: id, document, status, macro steps, and how it stands: why it
/// is interrupted, that it is paused, the fault, or the port by which it ended. Error `io`: this is no core.
Expected<std::string> core_line(const Value& core);

}  // namespace race::server
