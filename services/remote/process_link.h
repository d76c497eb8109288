// ProcessLink: the server's end of the connection of one process: what the process says, and how long it has been
// silent. Held by its socket.
//
// Threads: the sockets', but for the hello (received()). What the process says reaches the host on the thread of its
// group, in order.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/remote/remotes.h"
#include "services/remote/send_queue.h"

namespace race::remote {

class ProcessLink {
 public:
  static constexpr int kPingsPerHeartbeat = 4;
  static constexpr std::size_t kHelloBytes = 4 * 1024 * 1024;  // of the first message, at most

  /// Of a process that may bring what is of these groups, by name (Remotes::add), and the account that it has; empty:
  /// it is one of the server's own user.
  ProcessLink(Remotes& remotes, std::vector<std::string> groups, std::string account = {});
  ~ProcessLink();
  ProcessLink(const ProcessLink&) = delete;
  ProcessLink& operator=(const ProcessLink&) = delete;

  /// What waits to be sent; the connection is to end once that is drained.
  SendQueue& out();
  /// A message came. An invalid one is answered `refused`, and the process is disconnected. The first is the hello: it
  /// is checked before this returns, on whatever thread, while nobody else uses the link.
  void received(EncodedMessage message);
  /// Whether the hello was.
  bool accepted() const { return accepted_; }
  /// Why it was not; nothing: it was, or has not come.
  const std::optional<Error>& refusal() const { return refusal_; }
  /// Whether what has come is not handled yet: what the process says meanwhile is to stay in its socket.
  bool is_behind() const;
  /// `handled` is called, on any thread, whenever something was handled; not any more when this returns with another.
  void on_handled(std::function<void()> handled);
  /// To be called kPingsPerHeartbeat times in the time of the heartbeat, once the hello is accepted: sends a ping;
  /// disconnects a process that has answered none of the last kPingsPerHeartbeat, or does not read what it is told.
  void check_heartbeat();
  /// The connection has ended, because of `why`.
  void disconnect(const std::string& why);
  /// Whether the process is disconnected or was refused.
  bool disconnected() const { return disconnected_; }

 private:
  struct Process;

  Expected<void> accept_hello(const EncodedMessage& message);

  Remotes& remotes_;
  const Remotes::Owner owner_;
  std::optional<Error> refusal_;
  std::shared_ptr<Process> process_;  // held by work on its way to the group too
  bool accepted_ = false, disconnected_ = false;
  int unanswered_ = 0;  // pings since the last pong
  std::int64_t pings_ = 0;
};

}  // namespace race::remote
