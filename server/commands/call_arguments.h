// The arguments of an operation, as the words of `race call SERVICE.OPERATION [ARGUMENT...]`. Pure.
#pragma once

#include <span>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

struct CalledOperation {
  std::string service, operation;
};

/// "robot.state". Error `syntax`.
Expected<CalledOperation> read_operation(const std::string& text);

/// Adds `args` or `kwargs` to a call (schemas/service_call.json): one JSON list, one JSON object, or words NAME=VALUE
/// whose value is JSON, or else a text. Errors, with the word as path: those of parse_json; `syntax` (it is none of
/// these); `duplicate`.
Expected<void> read_call_arguments(std::span<const std::string> words, Dict& call);

}  // namespace race::server
