// Why a port fired or does not fire, as schemas/why.json.
#pragma once

#include <atomic>
#include <string>

#include "core/execution/replay.h"

namespace race::execution {

/// Of an execution as it stands.
Value why_json(Execution& execution, semantics::PortId port);

/// As things were before micro step `micro`, from 0, of macro step `step`. Requires as Replay::before. Errors: those of
/// it; `not_found`: there was no such port.
Expected<Value> why_before(Replay& replay, const std::string& port, std::uint64_t step, int micro,
                           const std::atomic<bool>* stop = nullptr);

}  // namespace race::execution
