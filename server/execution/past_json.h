// A moment of a run, with the digest by which it is compared.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/execution/past.h"

namespace race::server {

/// schemas/past.json. Requires and errors: as execution::past.
Expected<Value> past_json(execution::Replay& replay, std::uint64_t step, int micro,
                          const std::atomic<bool>* stop = nullptr);

}  // namespace race::server
