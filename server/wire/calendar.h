// The calendar: what time it is for people. Of revisions and runs; nothing that a task sees depends on it.
#pragma once

#include <cstdint>

namespace race::server {

/// Milliseconds since 1970, UTC.
std::int64_t now_ms() noexcept;

}  // namespace race::server
