// POST /api/v1/cores/{id}/pause, resume, stop, confirm_edit.
#include <limits>

#include "server/execution/cores.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {

namespace {

void command(const Request& request, Respond respond, Cores& cores, void (Core::*what)(Done<Value>)) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  ((**core).*what)(answer_to(std::move(respond)));
}

Checked<std::optional<bool>> read_supervised(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return read_body(text, [](Fields& fields) { return fields.boolean("supervised"); });
}

}  // namespace

void pause_core(const Request& request, Respond respond, Cores& cores) {
  command(request, std::move(respond), cores, &Core::pause);
}
void resume_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const auto supervised = read_supervised(request.body);
  if (!supervised) return respond(tl::unexpected(supervised.error()));
  const auto control = control_of(request, manual);
  if (!control) return respond(failed(control.error()));
  (*core)->resume(answer_to(std::move(respond)), {*control, *supervised});
}
void stop_core(const Request& request, Respond respond, Cores& cores) {
  command(request, std::move(respond), cores, &Core::stop);
}

// Only who has the controls confirms, and only the revision that they have seen.
void confirm_core_edit(const Request& request, Respond respond, Cores& cores, ManualControl& manual) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const auto revision = read_body(request.body, [](Fields& fields) {
    return fields.integer("revision", 1, std::numeric_limits<std::int64_t>::max(), kRequired).value_or(0);
  });
  if (!revision) return respond(tl::unexpected(revision.error()));
  const auto control = control_of(request, manual);
  if (!control) return respond(failed(control.error()));
  if (*control == 0) return respond(failed({ErrorCode::leased, "take the controls of the cell first", {}}));
  (*core)->confirm_edit(*revision, answer_to(std::move(respond)));
}

}  // namespace race::server
