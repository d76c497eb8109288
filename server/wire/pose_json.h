// Poses of a cell as messages have them: the shapes of their values.
//
// Threads: any; pure.
#pragma once

#include <cstddef>

#include "core/value/value.h"

namespace race::server {

/// A number that is finite.
bool is_number(const Value& value);
/// A list of so many of these.
bool are_numbers(const Value& value, std::size_t count);
/// schemas/pose.json; its orientation has length 1, as far as rounding goes.
bool is_pose(const Value& value);
/// A hand or a push of schemas/person.json.
bool is_touch(const Value& value);

}  // namespace race::server
