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
inline constexpr std::chrono::seconds kReplayTimeout{20};
/// What `replay` gives on the thread of replays, where it may go on for a moment when the answer is given: it must own
/// what it uses. Errors also: those of Worker::ask.
Handled answer_replay(Worker& replays, std::function<Expected<Value>(const Worker::Stop&)> replay);

}  // namespace race::server
