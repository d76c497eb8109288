// Answering: a request that has arrived is answered by the handlers, there or later; no thread waits for that.
//
// Threads: the sockets'.
#pragma once

#include <cstddef>

#include "server/http/beast.h"
#include "server/http/message.h"
#include "server/http/serving.h"

namespace race::server {

/// A reply, and its size (bytes of the text, or Value::size_units): counted where it was made, as that takes its time.
struct Answered {
  Reply reply;
  std::size_t units = 0;
};

/// Has the request answered by `handlers`, there or later, and goes on here with the reply. `Request::gone` is set when
/// the client closes the connection, or its half of it, before.
awaitable<Answered> reply_to(Request request, NetStream& stream, Pool& handlers, Context& context);

}  // namespace race::server
