// What is asked of stored runs with more than a call: their list and their derivations, page by page.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/client.h"

namespace race::client {

/// Each run (runs.json), of one document or of all, the newest first. Errors: those of the route.
Answered<List> all_runs(const Client& client, const std::optional<std::string>& document = {});

/// The derivations of the macro steps `first` to `last` (absent: all so far) of a run, in order (derivations.json),
/// computed anew each time. Errors: 422 `version`: another version of the server executed it; 413 `too_large`: its
/// replay takes too long.
Answered<List> run_derivations(const Client& client, std::string_view run, std::int64_t first = 1,
                               std::optional<std::int64_t> last = {});

}  // namespace race::client
