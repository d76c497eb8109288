// POST /api/v1/control/answer: a person at the cell lets somebody else take the controls, or not. PUT
// /api/v1/control/mode: the mode of the cell.
#include <limits>

#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {
namespace {

struct Decision {
  std::int64_t id = 0;
  bool allow = false;
};

Decision read_answer(Fields& fields) {
  const auto id = fields.integer("request", 1, std::numeric_limits<std::int64_t>::max(), kRequired);
  if (!fields.find("allow", kRequired)) fields.violation(ErrorCode::missing, "`allow` says whether they may", "allow");
  return {id.value_or(0), fields.boolean("allow").value_or(false)};
}

// Programming, in which less moves, of a text that is no mode: a violation.
Mode read_mode(Fields& fields) {
  const auto text = fields.text("mode", kRequired);
  const auto mode = text ? mode_of(*text) : std::nullopt;
  if (text && !mode) fields.violation(ErrorCode::out_of_range, "`mode` must be `execution` or `programming`", "mode");
  return mode.value_or(Mode::programming);
}

}  // namespace

Handled answer_control_request(const Request& request, ManualControl& manual, Control& control) {
  const auto decision = read_body(request.body, read_answer);
  if (!decision) return tl::unexpected(decision.error());
  if (auto answered = manual.answer_request(request.identity, decision->id, decision->allow); !answered)
    return failed(answered.error());
  return ok(control.json());
}

Handled set_mode(const Request& request, CellStop& cell_stop, ManualControl& manual, Control& control) {
  const auto mode = read_body(request.body, read_mode);
  if (!mode) return tl::unexpected(mode.error());
  const auto number = control_of(request, manual);
  if (!number) return failed(number.error());
  if (auto set = cell_stop.set_mode(*number, *mode); !set) return failed(set.error());
  return ok(control.json());
}

}  // namespace race::server
