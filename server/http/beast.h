// What the files that know Boost.Beast share (race_beast of server/CMakeLists.txt); no others include it.
#pragma once

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace race::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::awaitable;
using boost::system::error_code;

inline constexpr auto kAsTuple = asio::as_tuple(asio::use_awaitable);

}  // namespace race::server
