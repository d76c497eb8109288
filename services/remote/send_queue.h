// SendQueue: the encoded messages that wait to be sent to one end of a connection (message_queue.h).
//
// Threads: any.
#pragma once

#include <cstddef>
#include <string>

#include "services/remote/message_queue.h"

namespace race::remote {

/// One WebSocket message.
struct EncodedMessage {
  std::string bytes;
  bool binary = false;  // else UTF-8 text
};

inline std::size_t size_of(const EncodedMessage& message) { return message.bytes.size(); }

using SendQueue = MessageQueue<EncodedMessage>;

}  // namespace race::remote
