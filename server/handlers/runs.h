// What the handlers of /api/v1/runs share.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/execution/journal.h"
#include "server/execution/core.h"
#include "server/handlers/handlers.h"
#include "server/store/runs.h"
#include "server/threads/worker.h"

namespace race::server {

/// The number that `text` is; 0, which no run has, if it is none.
RunId run_number(std::string_view text);
/// The run of the route's `run`, or `not_found`.
Expected<RunRecord> run_of(const Request& request, Runs& runs);
/// What is durable of the journal of a hosted run. Errors: those of Core::position() and journal_of().
Expected<execution::Journal> journal_of(Core& core, Runs& runs);
/// A JSON text as it is, or its error.
Handled answer_text(Expected<std::string> text);

/// Within which a replay must be done.
const Worker::Limit kReplayLimit{std::chrono::seconds(20),
                                 {ErrorCode::too_large, "the replay takes longer than 20 seconds"}};
/// Responds with what `replay` gives on the thread of replays, until the client has gone. It may go on for a moment
/// when that is so: it must own what it uses. Errors also: those of Worker::ask, `too_large` if it takes long.
void answer_replay(const Request& request, Respond respond, Worker& replays,
                   std::function<Expected<Value>(const Stop&)> replay);

}  // namespace race::server
