#include "server/mcp/output.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>

#include "core/value/json.h"

namespace race::server::mcp {
namespace {

// For a client that has closed its end of our input, and still reads.
constexpr int kLastWaitMs = 300;
// A pipe that can be written takes so much without waiting.
constexpr std::size_t kAtOnce = PIPE_BUF;

}  // namespace

void Output::send(const Value& message) {
  const std::string line = to_json(message) + '\n';
  const services::MutexLock lock(mutex_);
  if (!closed_) closed_ = !write(line);
}

bool Output::write(std::string_view text) {
  while (!text.empty()) {
    if (!wait_until_writable()) return false;
    const ssize_t count = ::write(out_, text.data(), std::min(text.size(), kAtOnce));
    if (count < 0 && errno != EINTR && errno != EAGAIN) return false;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool Output::wait_until_writable() const {
  std::array<pollfd, 2> files{{{out_, POLLOUT, 0}, {in_, POLLRDHUP, 0}}};
  for (;;) {
    if (::poll(files.data(), files.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    if (files[0].revents != 0) return true;  // if nobody reads, the write says so
    return ::poll(files.data(), 1, kLastWaitMs) > 0;
  }
}

}  // namespace race::server::mcp
