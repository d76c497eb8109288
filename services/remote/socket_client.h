// SocketClient: the process' end of the connection: one WebSocket to the server's /api/v1/components. Boost stays in
// socket_client.cpp.
//
// Threads: made and destroyed on one; `received` and `closed` are called on a thread of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "services/remote/address.h"
#include "services/remote/send_queue.h"

namespace race::remote {

class SocketClient {
 public:
  struct Handlers {
    std::function<void(EncodedMessage)> received;
    std::function<void(std::string why)> closed;  // once, unless the client is destroyed before
  };

  /// Connects within three seconds, as the account of `token`, if it is not empty. Sends what `out` has until that is
  /// drained or overflows, or the connection ends; it outlives the client. Errors: `unavailable` (no server answers),
  /// `conflict` (the server accepts no components), `rights` (it does not accept this account).
  static Expected<std::unique_ptr<SocketClient>> connect(const Address& address, const std::string& token,
                                                         SendQueue& out, Handlers handlers);
  /// Ends the connection.
  ~SocketClient();

 private:
  struct Socket;
  explicit SocketClient(std::unique_ptr<Socket> socket);
  std::unique_ptr<Socket> socket_;
};

}  // namespace race::remote
