// HttpServer: the sockets of `race serve`: HTTP and the stream on one loopback port. All of Beast is in listener.cpp
// and sessions.cpp; what is done with a request is in request_filter.h, static_files.h, stream/ and behind `Backend`.
//
// Threads: run() is the one that owns the sockets; handlers run on a pool of their own and may wait there.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "server/http/message.h"
#include "server/stream/displays.h"
#include "server/stream/hub.h"
#include "server/stream/requests.h"
#include "services/remote/remotes.h"

namespace race::server {

/// What the sockets hand requests and connections to; outlives them. Threads: `handle` on any of the handlers' (it may
/// wait; what it throws ends the request: 503 without memory, else 500).
struct Backend {
  std::function<Reply(Request)> handle;  // requests to /api/
  Hub& hub;
  Displays& displays;
  EditRequests& edits;
  remote::Remotes& remotes;
};

class HttpServer {
 public:
  /// Timeouts and the number of connections; a connection beyond them is closed. All greater than 0.
  struct Limits {
    // For the first byte of a connection; then for its header; then for the body.
    std::chrono::milliseconds read_timeout{30'000};
    std::chrono::milliseconds idle_timeout{120'000};  // from an answer to the first byte of the next request
    int connections = 512;                            // at once
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
  /// Serves until SIGINT, SIGTERM or stop().
  void run();
  /// On any thread.
  void stop();

 private:
  struct Sockets;
  explicit HttpServer(std::unique_ptr<Sockets> sockets);
  std::unique_ptr<Sockets> sockets_;
};

}  // namespace race::server
