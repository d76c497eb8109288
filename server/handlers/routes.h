// The table of routes: what stands in api/openapi.yaml, and nothing else, can be reached.
//
// Threads: any thread of the handlers' pool.
#pragma once

#include <span>
#include <string_view>
#include <tuple>

#include "server/handlers/handlers.h"

namespace race::server {

class EventLog;

/// What handlers use; each gets those that are its parameters.
using Resources = std::tuple<Documents&, Editing&, BootList&, Backups&, Runs&, Samples&, Cores&, LiveEdits&, Worker&,
                             Cell&, EventLog&, IdempotentAnswers&>;

struct Route {
  std::string_view method;
  std::string_view pattern;  // "/api/v1/cores/{id}" (server/wire/path_pattern.h)
  Handled (*handle)(const Request&, const Resources&);
  bool has_body = false;        // which the handler reads; others take none, or an empty object
  std::string_view query = {};  // names of its parameters, between spaces
  bool creates = false;         // something each time, unless the request has an Idempotency-Key
};

/// All of them. The listener serves the WebSockets itself (GET /api/v1/stream and /api/v1/components).
std::span<const Route> routes();

/// Answers a request by its route; 405 for a path with other methods, 404 for none; 400 for a parameter that the route
/// does not have, 422 for a body that it does not have. An exception of a handler (out of memory, a bug of ours) is
/// logged and answered 500; the server continues. What a GET finds damaged is logged, too.
Reply handle(Request request, const Resources& resources);

}  // namespace race::server
