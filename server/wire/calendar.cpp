#include "server/wire/calendar.h"

#include <chrono>

namespace race::server {

std::int64_t now_ms() noexcept {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace race::server
