#include "server/execution/outgoing_calls.h"

#include <thread>

namespace race::server {

void make_calls(services::Host& host, const std::string& core, const std::vector<semantics::OutgoingCall>& calls,
                bool is_over) {
  constexpr unsigned kAtOnce = 64;
  unsigned made = 0;
  for (const semantics::OutgoingCall& call : calls) {
    if (call.supersedes != 0) host.abandon({core, call.supersedes});
    if (++made % kAtOnce == 0) std::this_thread::yield();  // here, and not while it has the lock that others wait for
    host.call({core, call.number}, call.service, call.name, call.args, call.kwargs);
  }
  if (is_over) host.abandon_all(core);
}

}  // namespace race::server
