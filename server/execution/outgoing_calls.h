// How the calls of a run reach the host, and how the host learns which of them nobody waits for any more.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/semantics/context.h"
#include "services/host/host.h"

namespace race::server {

/// Makes the calls that left a run, in order, as `core`, with its fencing number (services::MotionGate). A call that
/// one of them supersedes is abandoned first, so that the later one finds its place free; when the run is over, all
/// are.
void make_calls(services::Host& host, const std::string& core, std::uint64_t fence,
                const std::vector<semantics::OutgoingCall>& calls, bool is_over);

}  // namespace race::server
