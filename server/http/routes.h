// The table of routes: what stands in api/openapi.yaml, and nothing else, can be reached.
#pragma once

#include <span>
#include <string_view>

#include "server/handlers/handlers.h"
#include "server/http/listener.h"

namespace race::server {

struct Route {
  std::string_view method;
  std::string_view pattern;  // "/api/v1/cores/{id}"
  Handled (*handler)(const Request&, Application&);
};

/// All of them. The stream (GET /api/v1/stream) is served by the listener itself.
std::span<const Route> routes();

/// The values of the pattern's {names} if `path` fits; a name takes one part of the path, which is not empty.
std::optional<std::map<std::string, std::string, std::less<>>> match(std::string_view pattern, std::string_view path);

/// Answers a request: by its route; 405 for a path with other methods, 404 for none. What a handler throws (memory, a
/// mistake of ours) is answered 500; the server goes on.
Reply handle(Request request, Application& app);
/// The application as the sockets see it.
Backend make_backend(Application& app);

}  // namespace race::server
