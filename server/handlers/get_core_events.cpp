// GET /api/v1/cores/{id}/events: what the channel of its state gives, for clients without a WebSocket.
#include "server/execution/cores.h"
#include "server/handlers/channel_events.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {

Handled get_core_events(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  return channel_events(request, fill(kCoreStateChannel, {(*core)->id()}));
}

}  // namespace race::server
