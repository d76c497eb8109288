// Stop: how work learns that nobody waits for what it makes.
//
// Threads: any.
#pragma once

#include <atomic>
#include <memory>

namespace race::server {

/// True: the work should end soon; what it gives is thrown away. It never becomes false again.
using Stop = std::atomic<bool>;
/// Shared by who works and who waits.
using SharedStop = std::shared_ptr<Stop>;

}  // namespace race::server
