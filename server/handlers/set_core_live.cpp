// PUT /api/v1/cores/{id}/live: whether the core follows the edits of its document.
#include "server/execution/live_edits.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Checked<bool> read_live(const std::string& text) {
  return read_body(text, [](Fields& fields) {
    const auto live = fields.find("live", kRequired) ? fields.boolean("live") : std::nullopt;
    return live.value_or(false);
  });
}

}  // namespace

void set_core_live(const Request& request, Respond respond, Cores& cores, LiveEdits& edits) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const auto live = read_live(request.body);
  if (!live) return respond(tl::unexpected(live.error()));
  (*core)->set_live(*live, [respond = std::move(respond), &edits, live = *live](Expected<Value> changed) {
    if (changed && live) edits.changed(changed->find("document")->as_string());
    respond(answer(std::move(changed)));
  });
}

}  // namespace race::server
