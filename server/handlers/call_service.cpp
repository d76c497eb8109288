// POST /api/v1/services/{service}/calls: one operation of a service, called by a person or their program.
#include <chrono>
#include <memory>

#include "core/value/json.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"
#include "server/threads/deadlines.h"

namespace race::server {
namespace {

constexpr std::chrono::seconds kResponseTime{5};

Checked<PersonCall> read_service_call(const Request& request) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  PersonCall call = read_call(request.parameters.at("service"), fields);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return call;
}

}  // namespace

void call_service(const Request& request, Respond respond, ManualControl& manual, Deadlines& deadlines) {
  const auto call = read_service_call(request);
  if (!call) return respond(tl::unexpected(call.error()));
  const auto number = control_of(request, manual);
  if (!number) return respond(failed(number.error()));
  const auto once = std::make_shared<Once<Value>>(answer_to(as_routine(std::move(respond))));
  const auto caller = manual.call_by_request({request.identity, *number}, *call,
                                             [once](Dict response) { (*once)(std::move(response)); });
  if (!caller) return (*once)(tl::unexpected(caller.error()));
  deadlines.after(kResponseTime, [once, caller = *caller, &manual] {
    if (manual.give_up(caller))
      (*once)(unexpected(ErrorCode::unavailable, "the service has not responded yet; what was called may be done"));
  });
}

}  // namespace race::server
