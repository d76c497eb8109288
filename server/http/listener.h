// HttpServer: the sockets of `race serve`: HTTP and the stream, on one loopback port, and over TLS for a network. What
// is done with a request is in request_filter.h, static_files.h, stream/ and behind `Backend`.
//
// Threads: run() is the one that owns the sockets; handlers run on a pool of their own, and answer there or later.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/http/answer.h"
#include "server/http/connections.h"
#include "server/http/message.h"
#include "server/metrics/metrics.h"
#include "server/stream/control_requests.h"
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
  /// POST /api/v1/stop, on the sockets' thread and on that of the stop server, which knows an address alone: it waits
  /// for nothing.
  std::function<Reply(const Identity&)> stop;
  Hub& hub;
  Displays& displays;
  EditRequests& edits;
  PresenceRequests& presence;
  ControlRequests& control;
  ClientRecords& records;
  remote::Remotes& remotes;
  ClientGauges& clients;
  /// The server is to end, and why: told once, on the sockets' thread; waits for nothing. `done`, on any thread: the
  /// sockets may end. Until then they serve who is connected, for kStandTimeout at most.
  std::function<void(const std::string& why, std::function<void()> done)> end = {};
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

  /// Where the server listens.
  struct Place {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;  // 0: any free one
    // TLS, as PEM, for these names and addresses of the server. Without, it is reached by this machine alone.
    struct Tls {
      std::vector<std::string> names;
      std::string chain, key;
    };
    std::optional<Tls> tls = {};
    std::uint16_t stop_port = 0;  // of the stop server (stop_server.h); 0: any free one
  };
  /// Listens at all places, one at least, and serves the files of `web`, if it is not empty, beside the routes.
  /// Requires that a place without TLS is of loopback. Errors, with the address and port as path: `io`: the port cannot
  /// be had; `not_accepted`: no certificate, or not of its key.
  static Expected<std::unique_ptr<HttpServer>> listen(const std::vector<Place>& places, std::string web,
                                                      Backend backend, const Limits& limits);
  /// On 127.0.0.1:`port`.
  static Expected<std::unique_ptr<HttpServer>> listen(std::uint16_t port, std::string web, Backend backend,
                                                      const Limits& limits) {
    return listen(std::vector<Place>{{.port = port}}, std::move(web), std::move(backend), limits);
  }
  static Expected<std::unique_ptr<HttpServer>> listen(std::uint16_t port, std::string web, Backend backend) {
    return listen(port, std::move(web), std::move(backend), Limits());
  }
  ~HttpServer();

  /// Of the place of this number, from 0.
  std::uint16_t port(std::size_t place = 0) const;
  std::uint16_t stop_port(std::size_t place = 0) const;
  /// Who connects to this place, or to its stop server, from now on gets this certificate; who is connected stays. Any
  /// thread. Error `not_accepted`: it is none, or not of its key; the one of before stays.
  Expected<void> set_certificate(std::size_t place, const std::string& chain, const std::string& key);
  /// For all that moves to stand when the server ends.
  static constexpr std::chrono::milliseconds kStandTimeout{3'000};
  /// Serves until SIGINT, SIGTERM or stop(). Then nobody connects any more, and the backend ends what is under way
  /// (Backend::end); then nothing begins any more, WebSockets get a close frame that says why, and what is being
  /// answered or said may end for half a second; requests that no handler has begun are dropped. The same signal once
  /// more ends the process at once.
  void run();
  /// On any thread.
  void stop();

 private:
  struct Sockets;
  explicit HttpServer(std::unique_ptr<Sockets> sockets);
  std::unique_ptr<Sockets> sockets_;
};

}  // namespace race::server
