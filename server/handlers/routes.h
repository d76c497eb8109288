// The table of routes: what stands in api/openapi.yaml, and nothing else, can be reached.
//
// Threads: any thread of the handlers' pool.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>

#include "server/handlers/handlers.h"
#include "server/http/answer.h"

namespace race::server {

class EventLog;

/// What handlers use; each gets those that are its parameters. The pool is that of backups and their restores.
using Resources =
    std::tuple<Documents&, DocumentBreakpoints&, Editing&, Proposals&, Proposing&, BootList&, Backups&, Runs&, Samples&,
               Pictures&, Cores&, LiveEdits&, Worker&, Deadlines&, Pool&, Cell&, EventLog&, IdempotentAnswers&,
               Accounts&, Passwords&, Attempts&, Tickets&, AuditLog&, AuthorityCertificate&, Control&, CellStop&,
               Metrics&, ManualControl&, Pairings&, NetworkAddresses&, RunQueue&, Tasks&>;

struct Route {
  std::string_view method;
  std::string_view pattern;  // "/api/v1/cores/{id}" (server/wire/path_pattern.h)
  void (*handle)(const Request&, Respond, const Resources&);
  bool has_body = false;        // which the handler reads; others take none, or an empty object
  std::string_view query = {};  // names of its parameters, between spaces
  bool creates = false;         // something each time, unless the request has an Idempotency-Key
  /// Whether it may take long, so that its client may prefer to be answered before (tasks.h); `stoppable`: its work
  /// looks at Request::gone.
  enum class Long : std::uint8_t { no, yes, stoppable } is_long = Long::no;
};

/// All of them. The listener serves the WebSockets itself.
std::span<const Route> routes();
/// The paths of the WebSockets, which are routes of GET.
std::span<const std::string_view> websocket_paths();

/// The pattern of the route of a request, also of the WebSockets; empty: there is none.
std::string_view pattern_of(std::string_view method, std::string_view path);

/// Answers a request by its route, at once or later; 405 for a path with other methods, 404 for none; 400 for a
/// parameter that the route does not have, 422 for a body that it does not have. What a GET finds damaged is logged,
/// too. Throws what a handler throws.
void handle(Request request, const Resources& resources, const Answer& answer);

}  // namespace race::server
