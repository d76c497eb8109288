// What conversations ask by the name of a method of the clients.
#pragma once

#include <string_view>

#include "api/cpp/client/client.h"
#include "tests/client_cpp/given.h"

namespace race::client {

/// The answer to a method, such as `documents.put`: of a function of the library, or of the call that it is. Throws
/// std::invalid_argument: there is no such method, or an argument is missing or of another type.
Answered<Value> ask(std::string_view method, Client& client, const Given& given);

}  // namespace race::client
