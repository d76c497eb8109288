// POST /api/v1/control/answer: a person at the cell lets somebody else take the controls, or not. PUT
// /api/v1/control/mode: the mode of the cell.
#include <limits>

#include "core/value/json.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {

Handled answer_control_request(const Request& request, ManualControl& manual, Control& control) {
  auto json = parse_json(request.body);
  if (!json) return failed(std::move(json).error());
  std::vector<Error> errors;
  Fields fields(*json, "", "the request", errors, Fields::Paths::field);
  const auto id = fields.integer("request", 1, std::numeric_limits<std::int64_t>::max(), kRequired);
  if (!fields.find("allow", kRequired)) fields.violation(ErrorCode::missing, "`allow` says whether they may", "allow");
  const bool allow = fields.boolean("allow").value_or(false);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (auto answered = manual.answer_request(request.identity, *id, allow); !answered) return failed(answered.error());
  return ok(control.json());
}

Handled set_mode(const Request& request, ManualControl& manual, Control& control) {
  auto json = parse_json(request.body);
  if (!json) return failed(std::move(json).error());
  std::vector<Error> errors;
  Fields fields(*json, "", "the request", errors, Fields::Paths::field);
  const auto text = fields.text("mode", kRequired);
  const auto mode = text ? mode_of(*text) : std::nullopt;
  if (text && !mode) fields.violation(ErrorCode::out_of_range, "`mode` must be `execution` or `programming`", "mode");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  const auto number = control_of(request, manual);
  if (!number) return failed(number.error());
  if (auto set = manual.set_mode(*number, *mode); !set) return failed(set.error());
  return ok(control.json());
}

}  // namespace race::server
