#include "server/execution/outgoing_calls.h"

namespace race::server {

void make_calls(services::Host& host, const std::string& core, std::uint64_t fence,
                const std::vector<semantics::OutgoingCall>& calls, bool is_over) {
  for (const semantics::OutgoingCall& call : calls) {
    host.call({core, call.number, fence}, call.service, call.name, call.args, call.kwargs, {}, call.supersedes);
  }
  if (is_over) host.abandon_all(core);
}

}  // namespace race::server
