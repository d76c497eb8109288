// Output: where messages go, one a line. A client that reads nothing holds up who writes, but not the end: when it has
// closed what it writes to us, too, no more is written.
//
// Threads: any; messages are written one after the other.
#pragma once

#include <string_view>

#include "core/value/value.h"
#include "services/mutex.h"

namespace race::server::mcp {

class Output {
 public:
  /// `in`: from which the client's messages come: whether it has gone is seen there.
  Output(int out, int in) : out_(out), in_(in) {}

  /// Writes the message; what nobody takes any more is dropped. SIGPIPE must be ignored.
  void send(const Value& message) EXCLUDES(mutex_);

 private:
  bool write(std::string_view text) REQUIRES(mutex_);
  bool wait_until_writable() const REQUIRES(mutex_);

  const int out_, in_;
  services::Mutex mutex_;
  bool closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::server::mcp
