// Errors as clients see them, in responses and on the stream.
#pragma once

#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// schemas/errors.json: {"errors": [{"path", "code", "message"}]}, with `line` and `column` where they are known.
Value errors_json(const std::vector<Error>& errors);

}  // namespace race::server
