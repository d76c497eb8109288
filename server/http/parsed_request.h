// Requests as Beast parses them, and what the rest of the server sees of them. Without sockets.
#pragma once

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>

#include "core/value/expected.h"
#include "server/http/message.h"

namespace race::server {

using RequestParser = boost::beast::http::request_parser<boost::beast::http::string_body>;

/// A header and a body have at most what RequestFilter says.
void set_limits(RequestParser& parser);

/// Beast's request as ours, without its body. Error: the target.
Expected<Request> to_request(const boost::beast::http::request<boost::beast::http::string_body>& from);

/// The response to a request that could not be read; nothing: the connection is gone.
std::optional<Reply> read_error(boost::system::error_code error);

}  // namespace race::server
