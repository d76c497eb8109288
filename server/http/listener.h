// HttpServer: the sockets of `race serve`: HTTP and the stream on one loopback port. What is done with a request is in
// request_filter.h, static_files.h, stream/ and behind `Backend`.
//
// Threads: run() is the one that owns the sockets; handlers run on a pool of their own, and answer there or later.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "server/http/answer.h"
#include "server/http/connections.h"
#include "server/http/message.h"
#include "server/stream/displays.h"
#include "server/stream/hub.h"
#include "server/stream/requests.h"
#include "services/remote/remotes.h"

namespace race::server {

/// What the sockets hand requests and connections to; outlives them. Threads: `handle` on any of the handlers'; what it
/// throws ends the request (503 without memory, else 500). It may answer later, on any thread, also when there are no
/// sockets any more.
struct Backend {
  /// Who sends a request to /api/, from its header alone; or why it is refused. On the sockets' thread: it waits for
  /// nothing.
  std::function<tl::expected<Identity, Reply>(const Request&)> admit;
  std::function<void(Request, const Answer&)> handle;  // requests to /api/
  std::function<Reply()> health;  // GET /api/v1/health, on the sockets' thread: it waits for nothing
  Hub& hub;
  Displays& displays;
  EditRequests& edits;
  PresenceRequests& presence;
  ClientRecords& records;
  remote::Remotes& remotes;
};

class HttpServer {
 public:
  /// Timeouts, and what clients may take. All greater than 0.
  struct Limits {
    // For the first byte of a connection; then for its header; then for the body.
    std::chrono::milliseconds read_timeout{30'000};
    std::chrono::milliseconds idle_timeout{120'000};    // from an answer to the first byte of the next request
    std::chrono::milliseconds write_timeout{10'000};    // for the client to take a MiB of an answer, or its rest
    std::chrono::milliseconds reserved_timeout{1'000};  // for the header of a reserved connection; then for its body
    Connections::Limits connections = {};
    std::size_t held_bytes = std::size_t{64} << 20U;  // of bodies, answers and unknown processes (byte_budget.h)
  };

  /// Listens on 127.0.0.1:`port` (0: any free one) and serves the files of `web`, if it is not empty, beside the
  /// routes. Error `io`: the port cannot be had.
  static Expected<std::unique_ptr<HttpServer>> listen(std::uint16_t port, std::string web, Backend backend,
                                                      const Limits& limits);
  static Expected<std::unique_ptr<HttpServer>> listen(std::uint16_t port, std::string web, Backend backend) {
    return listen(port, std::move(web), std::move(backend), Limits());
  }
  ~HttpServer();

  std::uint16_t port() const;
  /// Serves until SIGINT, SIGTERM or stop(). Then nothing begins any more, WebSockets get a close frame, and what is
  /// being answered or said may end for half a second; requests that no handler has begun are dropped.
  void run();
  /// On any thread.
  void stop();

 private:
  struct Sockets;
  explicit HttpServer(std::unique_ptr<Sockets> sockets);
  std::unique_ptr<Sockets> sockets_;
};

}  // namespace race::server
