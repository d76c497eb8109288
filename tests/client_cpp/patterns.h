// Patterns of conversations (api/conversations/README.md).
#pragma once

#include <optional>
#include <string>

#include "core/value/value.h"
#include "tests/client_cpp/values.h"

namespace race::client {

/// Why a value does not fit a pattern, and where; nothing: it does.
std::optional<std::string> mismatch(const Value& pattern, const Value& value, Values& saved,
                                    const std::string& path = "");

}  // namespace race::client
