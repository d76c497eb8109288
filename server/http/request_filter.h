// RequestFilter: which requests are refused from their header alone, so that no byte of a refused body is read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/http/message.h"

namespace race::server {

struct RequestFilter {
  static constexpr std::size_t kHeaderBytes = 16 * 1024;
  static constexpr std::uint64_t kBodyBytes = 4 * 1024 * 1024;
  static constexpr std::uint64_t kRunFileBytes = 16 * 1024 * 1024;  // of the file of a run: POST /api/v1/runs
  static constexpr std::size_t kMessageBytes = 64 * 1024;           // of the stream, from a client
  static constexpr std::size_t kControlBytes = 16 * 1024;           // from a person at the controls

  /// This machine alone: localhost, 127.0.0.1 and [::1] with this port are the names of the server.
  explicit RequestFilter(std::uint16_t port);
  /// A network: these names and addresses are, over TLS.
  RequestFilter(const std::vector<std::string>& names, std::uint16_t port);

  /// The refusal of a request, if it is refused: Transfer-Encoding (501), not exactly one Host of the allowed ones
  /// (400, 421), an Origin that is not the server's own on a request that changes something or opens the stream (403),
  /// a body that is not JSON (415) or too large (413). `upgrade`: it asks for a WebSocket.
  std::optional<Reply> refuse(const Request& request, bool upgrade) const;

  std::vector<std::string> hosts;    // "localhost:8080", in lower case
  std::vector<std::string> origins;  // "http://localhost:8080"
};

}  // namespace race::server
