// Responses: replies as they go over the wire, and how they leave.
#pragma once

#include <chrono>
#include <string_view>

#include "server/http/beast.h"
#include "server/http/message.h"
#include "server/http/net_stream.h"

namespace race::server {

using Response = http::response<http::string_body>;

struct ResponseOptions {
  bool keep_alive = false;
  bool head = false;  // without the body
  // Of a page: to where else it may send requests, as in a Content-Security-Policy; outlives the response.
  std::string_view connect_sources = {};
};

/// The response; if there is no memory for it, one that says so. Threads: any.
Response make_response(Reply reply, ResponseOptions options);

/// A request ends with a refusal that is not its own fault: the client may ask again, soon.
Reply overload(const std::string& message);
Reply no_memory();

/// Sends it; a client has `timeout` for each MiB (kResponsePiece). Whether another request may follow: it has left, and
/// keeps the connection alive.
awaitable<bool> send(NetStream& stream, Response response, std::chrono::milliseconds timeout);
inline constexpr std::size_t kResponsePiece = 1024 * 1024;

/// Takes what the client still sends, for a short time: closing would reset the connection before it has read the
/// response.
awaitable<void> drain(NetStream& stream);

}  // namespace race::server
