// Refusals of requests: errors with an HTTP status. The listener makes problem details (schemas/problem.json) of them.
#pragma once

#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/http/message.h"

namespace race::server {

/// 403 for `rights`, 404 for `not_found`, 409 `conflict`, 413 `too_large`, 503 `unavailable` and `io`, 400 what is not
/// JSON or out of range, else 422: a body that was understood and breaks a rule. The first error decides.
int status_of(const std::vector<Error>& errors);

Reply refusal(const std::vector<Error>& errors);
/// With another status.
Reply refusal(int status, const std::vector<Error>& errors);
/// One error of the HTTP layer itself, with a code that no document has.
Reply refusal(int status, const std::string& code, const std::string& message);

}  // namespace race::server
