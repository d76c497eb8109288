// ProcessSession: one connection of a process with components (process_host.h) to a server, from its hello to its end.
//
// Threads: that of the group; what the server says is handed to the process on the socket's.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/mutex.h"
#include "services/remote/address.h"
#include "services/remote/process_host.h"
#include "services/remote/send_queue.h"
#include "services/remote/socket_client.h"

namespace race::remote {

class ProcessSession {
 public:
  /// The connection is over when `stop` is true, too. `welcomed` is called on the socket's thread once the server has
  /// accepted the process.
  struct Options {
    const std::atomic<bool>& stop;
    std::function<void()> welcomed;
  };

  /// Connects `process`, to which all its components are attached, and says its hello. What `process` announces waits
  /// in `out`, which outlives it; both outlive the session. Errors: those of SocketClient::connect().
  static Expected<std::unique_ptr<ProcessSession>> connect(const Address& address, const std::string& token,
                                                           ProcessHost& process, SendQueue& out, Options options);
  ~ProcessSession();

  /// Steps the process in real time until the connection is over. Throws what a component throws, after which the
  /// process must not be used.
  void run();

  /// Why the connection has ended.
  std::string reason() const EXCLUDES(mutex_);
  /// Why the server does not accept the process: a list of {path, code, message}, as its message says it; null: it has
  /// not refused.
  Value refusal() const EXCLUDES(mutex_);

 private:
  ProcessSession(ProcessHost& process, Options options);

  void received(const EncodedMessage& encoded);
  void end(std::string why) EXCLUDES(mutex_);
  void end_invalid(const Error& error);

  ProcessHost& process_;
  const Options options_;
  std::atomic<bool> over_{false};
  mutable services::Mutex mutex_;
  std::string why_ GUARDED_BY(mutex_);
  Value refusal_ GUARDED_BY(mutex_);      // frozen
  std::unique_ptr<SocketClient> socket_;  // the last: its thread uses the others
};

}  // namespace race::remote
