// What RFC 6455 (4.2) asks of the header of a request for a WebSocket, beyond what makes it one.
#pragma once

#include <optional>

#include "server/http/message.h"

namespace race::server {

/// Why it is refused: 400: not exactly one key, or one that is not 16 bytes in base64 (4.2.1); 426: not version 13
/// (4.2.2).
std::optional<Reply> refuse_handshake(const Request& request);

}  // namespace race::server
