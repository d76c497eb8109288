// Server-Sent Events (WHATWG HTML, 9.2): one client that follows a channel of the stream in the answer to its request,
// without a WebSocket. The hub treats it as any other: sampled, caught up or cut in the same way.
//
// Threads: the sockets'.
#pragma once

#include <chrono>

#include "server/http/beast.h"
#include "server/http/connections.h"
#include "server/http/message.h"
#include "server/http/net_stream.h"
#include "server/http/response.h"
#include "server/stream/requests.h"

namespace race::server {

/// What such a client follows, and within which bounds.
struct EventTargets {
  Hub& hub;
  ClientRecords& records;
  std::chrono::milliseconds write_timeout;  // for the client to take an event
  bool chunked = true;                      // else, for HTTP/1.0, the end of the connection is that of the answer
};

/// Sends the header of `head`, then what the channel has, until the client leaves, takes an event too late, or is not
/// `identity` any more; or until the channel or the server ends.
awaitable<void> serve_events(NetStream stream, Response head, ChannelEvents events, Identity identity,
                             EventTargets targets, Connections::Place& place);

}  // namespace race::server
