// Session: one WebSocket, whatever is said on it.
//
// Threads: the sockets'.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "server/http/beast.h"
#include "server/http/connections.h"
#include "server/http/net_stream.h"
#include "server/http/wake_up.h"
#include "server/stream/requests.h"

namespace race::server {

/// A request whose header asks for a WebSocket.
using Upgrade = http::request<http::string_body>;

/// A WebSocket, and what wakes the coroutine that writes to it. Held by its coroutines, and by who sends to it.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  virtual ~Session() = default;

 protected:
  explicit Session(NetStream stream)
      : socket_(std::move(stream)),
        executor_(socket_.get_executor()),
        waker_(executor_),
        deadline_(executor_),
        identity_timer_(executor_) {}

  /// Whether it is open then; a message has at most `limit` bytes, and is one frame. `place` ends it from then on.
  awaitable<bool> accept(const Upgrade& request, std::size_t limit, Connections::Place& place);
  /// Runs a coroutine of this beside the others; what it throws is reported and ends the connection.
  void spawn(std::function<awaitable<void>()> coroutine);
  /// Ends the connection when `identity` is not current any more: an account that is removed or changed, a logout, a
  /// token that expires. Until identity_timer_ is cancelled once it is over_.
  awaitable<void> check_identity(const Identity& identity, const ClientRecords& records);
  /// Until somebody cancels waker_.
  awaitable<void> sleep();
  /// Sends one message, whose pieces stay until it is sent. False: it cannot be sent, or is not taken in time; the
  /// connection ends.
  awaitable<bool> send(std::vector<asio::const_buffer> pieces);
  void close() { beast::get_lowest_layer(socket_).close(); }
  /// Closes; what has not been taken is dropped.
  void reset();
  /// A close frame says why, after what is being sent.
  void end(websocket::close_code why);

  websocket::stream<NetStream> socket_;
  asio::any_io_executor executor_;
  asio::steady_timer waker_, deadline_, identity_timer_;
  bool over_ = false;

 private:
  void check_close_code();

  bool sending_ = false, ending_ = false;
};

}  // namespace race::server
