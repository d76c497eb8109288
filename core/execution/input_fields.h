// Parts of inputs as journals and scripts write them.
#pragma once

#include <optional>
#include <string_view>

#include "core/semantics/force.h"
#include "core/value/fields.h"

namespace race::execution {

/// Any JSON, frozen; nothing (a violation) if it is absent or beyond the limits of a text: `constant`, `too_deep`.
std::optional<Value> read_data(Fields& fields, std::string_view key);

/// `path`, `scope`, `name` and `value`. Violations: `missing`; `type`: there is no such scope; those of read_data;
/// `unknown_field`: a port has no value.
semantics::Force read_force(Fields& fields);

}  // namespace race::execution
