// What a service may say: values that the server reads as they are. Pure.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/value/value.h"

namespace race::client {

/// Why no message can have this value, such as "has a number that is not finite"; nothing: one can.
std::optional<std::string> unsayable(const Value& value);

/// The value for another thread, too.
inline Value frozen(Value value) { return std::move(value.freeze()); }

}  // namespace race::client
