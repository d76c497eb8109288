// StopServer: `POST /api/v1/stop` on ports and a thread of its own, which nothing else uses: whatever the rest of the
// server does, whoever reaches it stops the cell. It reads a header of 1 KiB at most and no body, parses no JSON, and
// waits for no disk, core or handler.
//
// Threads: the thread that makes it; `stop` is called on its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "server/http/stop_request.h"

namespace boost::asio::ssl {
class context;
}

namespace race::server {

class StopServer {
 public:
  static constexpr std::size_t kHeaderBytes = 1024;
  static constexpr std::size_t kMostClients = 64;  // of more, the one that has come first is closed

  /// `stop` gets the address of who stops the cell; it must wait for nothing.
  explicit StopServer(std::function<void(const std::string& address)> stop);
  ~StopServer();
  StopServer(const StopServer&) = delete;
  StopServer& operator=(const StopServer&) = delete;

  /// Listens, before begin(); `port` 0: any. `names` says for that port whom it answers. Error `io`.
  Expected<std::uint16_t> open(const std::string& address, std::uint16_t port,
                               std::shared_ptr<boost::asio::ssl::context> tls,
                               const std::function<StopNames(std::uint16_t port)>& names);
  /// Who connects to the place of this number, in the order of open(), from now on gets the certificate of `tls`. Any
  /// thread.
  void set_certificate(std::size_t place, std::shared_ptr<boost::asio::ssl::context> tls);
  /// Serves from now on, on its own thread.
  void begin();

 private:
  struct Sockets;
  std::unique_ptr<Sockets> sockets_;
};

}  // namespace race::server
