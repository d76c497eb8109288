// Operations of services, called by name.
#pragma once

#include <string_view>

#include "api/cpp/client/client.h"

namespace race::client {

/// Calls an operation of a service, by the key of the service (as in `svc.KEY`), with arguments by position and by
/// name, as its RSM has them; its result (null: none). Errors: with status 200, code, `service`, `operation` and
/// `error`: the service answers with an error, `unavailable` also if it has no such operation; 404: no such service;
/// 409 `leased`: it moves something, or somebody else has the controls; 429 and 503 `unavailable`: too many wait, or
/// there was no response within 5 s, and what it began may go on.
Answered<Value> call_service(const Client& client, std::string_view service, std::string_view operation,
                             List arguments = {}, Dict named = {});

}  // namespace race::client
