// The WebSockets: clients of the stream (stream_session.cpp), people at the controls (control_session.cpp), and
// processes of components (component_session.cpp).
#pragma once

#include "server/http/byte_budget.h"
#include "server/http/session.h"
#include "server/stream/control_requests.h"
#include "server/stream/requests.h"
#include "server/threads/strand.h"
#include "services/remote/remotes.h"

namespace race::server {

/// Serves one client of the stream until it leaves, or is not `identity` any more.
awaitable<void> serve_stream(NetStream stream, Upgrade request, Identity identity, StreamTargets targets,
                             Connections::Place& place);

/// Where what people at the controls say goes.
struct ControlTargets {
  ControlRequests& control;
  ClientRecords& records;
};
/// Serves one person at the controls until they leave, or are not `identity` any more.
awaitable<void> serve_control(NetStream stream, Upgrade request, Identity identity, ControlTargets targets,
                              Connections::Place& place);

/// Where what processes of components say goes; their first messages are read on `handlers`.
struct ComponentTargets {
  remote::Remotes& remotes;
  Hub& hub;
  Pool& handlers;
  ClientRecords& records;
};
/// Serves one process of components until it is lost. `unknown`: its share of what such processes may make the server
/// hold (ProcessLink::kHelloBytes), until its hello is accepted.
awaitable<void> serve_components(NetStream stream, Upgrade request, Identity identity, ComponentTargets targets,
                                 Connections::Place& place, ByteBudget::Share unknown);

}  // namespace race::server
