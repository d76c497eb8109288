// Values that a mock gives where nobody has listed one. Pure.
#pragma once

#include <random>

#include "core/value/value.h"

namespace race::server {

using Random = std::mt19937_64;

/// One of the values of a TYPE (core/rsm/type.h), of few that tell cases apart; null for no type. The same state of
/// `random` gives the same value.
Value any_value(const Value& type, Random& random);

/// An error response of the TYPE, with `code`, or with any code if that is empty.
Value any_error(const Value& type, const std::string& code, Random& random);

}  // namespace race::server
