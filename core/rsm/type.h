// TYPE (core/SEMANTICS.md, section 1): which values an operation's parameter, result or error and an event's data have.
// A type is kept as the JSON it was written in; null means that none was declared and anything fits. Pure functions.
#pragma once

#include <optional>
#include <string>

#include "core/value/value.h"

namespace race::rsm {

/// Why `type` is not a TYPE; nothing if it is one.
std::optional<std::string> malformed(const Value& type);

/// Where and why `value` is not of `type`, such as "`position[2]`: expected a number, got a string"; nothing if it is.
/// `number` takes ints too; a record has all of its fields, but optional ones, and no others; numbers in an enum are
/// compared as `==` of the function language does. An `image` is a dict with the ints `width` and `height`.
/// Requires a well-formed type, or null.
std::optional<std::string> mismatch(const Value& type, const Value& value);

}  // namespace race::rsm
