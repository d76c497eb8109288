// TYPEs (core/SEMANTICS.md, section 1) as the operation tables write them: a plain type is its name, such as "number";
// these make the others. Pure functions.
#pragma once

#include <utility>

#include "core/value/value.h"

namespace race::services::types {

/// A dict with these fields, {{"held", "bool"}, ...}.
inline Value record(Dict fields) { return Dict{{"record", std::move(fields)}}; }

/// A list of any length, or of `size` items.
inline Value list(Value item) { return Dict{{"list", std::move(item)}}; }
inline Value list(Value item, int size) { return Dict{{"list", std::move(item)}, {"size", size}}; }

/// A field or an argument that may be absent.
inline Value optional(Value type) { return Dict{{"optional", std::move(type)}}; }

/// One of these values.
inline Value one_of(List values) { return Dict{{"enum", std::move(values)}}; }

}  // namespace race::services::types
