// What the files that know Boost.Beast share: listener.cpp and sessions.cpp, no others.
#pragma once

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "server/stream/requests.h"
#include "services/remote/remotes.h"

namespace race::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::awaitable;

inline constexpr auto kAsTuple = asio::as_tuple(asio::use_awaitable);

/// A request whose header asks for a WebSocket.
using Upgrade = http::request<http::string_body>;

/// Serves one client of the stream until it leaves.
awaitable<void> serve_stream(beast::tcp_stream stream, Upgrade request, StreamTargets targets);
/// Serves one process of components until it is lost.
awaitable<void> serve_components(beast::tcp_stream stream, Upgrade request, remote::Remotes& remotes, Hub& hub);

}  // namespace race::server
