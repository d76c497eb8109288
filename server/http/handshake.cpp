#include "server/http/handshake.h"

#include "core/value/base64.h"
#include "server/http/refusal.h"

namespace race::server {

std::optional<Reply> refuse_handshake(const Request& request) {
  constexpr const char *kKey = "sec-websocket-key", *kVersion = "sec-websocket-version";
  if (request.count(kVersion) != 1 || request.header(kVersion) != "13") {
    Reply reply = refusal(426, "upgrade", "WebSockets of version 13 are served here");
    reply.headers.emplace_back("Upgrade", "websocket");
    reply.headers.emplace_back("Sec-WebSocket-Version", "13");
    return reply;
  }
  constexpr std::size_t kKeySize = 24;  // of 16 bytes
  const std::string_view key = request.header(kKey);
  if (request.count(kKey) != 1 || key.size() != kKeySize || !is_base64(key))
    return refusal(400, "upgrade", "a WebSocket needs exactly one Sec-WebSocket-Key, in base64");
  return std::nullopt;
}

}  // namespace race::server
