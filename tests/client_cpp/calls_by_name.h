// The functions of calls.h by the names of their operations in api/openapi.yaml.
#pragma once

#include <string_view>

#include "api/cpp/client/call.h"
#include "tests/client_cpp/given.h"

namespace race::client {

/// The call of an operation with parameters by their names in the interface. Throws std::invalid_argument: there is no
/// such operation, or a parameter is missing or of another type.
Call call_by_name(std::string_view operation, const Given& given);

}  // namespace race::client
