// Errors as clients see them, in responses and on the stream.
#pragma once

#include <span>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// Each as schemas/errors.json, `server_error`: {"path", "code", "message"}, with the code text that it is about (`id`,
/// `text`, `line`, `column`) where it is known.
List error_list(std::span<const Error> errors);

/// Sets `errors` to the first kMaxErrors; if there are more, sets `more_errors`, which is true.
void set_errors(Dict& json, const std::vector<Error>& errors);

/// schemas/errors.json
Value errors_json(const std::vector<Error>& errors);

}  // namespace race::server
