// Answering: a request that has arrived is answered by the handlers, there or later; no thread waits for that.
//
// Threads: the sockets'.
#pragma once

#include "server/http/beast.h"
#include "server/http/message.h"
#include "server/http/serving.h"

namespace race::server {

/// Has the request answered by `handlers`, there or later, and goes on here with the reply. `Request::gone` is set when
/// the client closes the connection, or its half of it, before.
awaitable<Reply> reply_to(Request request, beast::tcp_stream& stream, Pool& handlers, Context& context);

}  // namespace race::server
