// POST /api/v1/services/{service}/calls: one operation of a service, called by a person or their program.
#include <memory>

#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"
#include "server/http/refusal.h"
#include "server/threads/done.h"

namespace race::server {
namespace {

// Of who has their share, or all that may wait do: later again.
Handled call_refused(const Error& error) {
  const bool is_share = error.code == ErrorCode::too_large;
  if (!is_share && error.code != ErrorCode::unavailable) return failed(error);
  Reply reply = is_share ? refusal(429, "too_many", error.message) : refusal({error});
  reply.headers.emplace_back("Retry-After", "1");
  return reply;
}

}  // namespace

void call_service(const Request& request, Respond respond, ManualControl& manual) {
  const auto call =
      read_body(request.body, [&](Fields& fields) { return read_call(request.parameters.at("service"), fields); });
  if (!call) return respond(tl::unexpected(call.error()));
  const auto number = control_of(request, manual);
  if (!number) return respond(failed(number.error()));
  const auto once = std::make_shared<Once<Value>>(answer_to(as_routine(respond)));
  const auto begun = manual.call_by_request({request.identity, *number}, *call,
                                            [once](Expected<Dict> response) { (*once)(std::move(response)); });
  if (!begun) respond(call_refused(begun.error()));
}

}  // namespace race::server
