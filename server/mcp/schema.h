// What of JSON Schema the tools use for their arguments: type, properties, required, additionalProperties (false),
// enum, minimum, maximum, minLength. Pure.
#pragma once

#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server::mcp {

/// Every violation of the schema in `value`, with `path` and the names of fields as path: `type`, `missing`,
/// `unknown_field`, `out_of_range`.
std::vector<Error> violations(const Value& schema, const Value& value, const std::string& path);

}  // namespace race::server::mcp
