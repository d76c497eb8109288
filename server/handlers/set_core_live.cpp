// PUT /api/v1/cores/{id}/live: whether the core follows the edits of its document.
#include "core/value/json.h"
#include "server/execution/live_edits.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Checked<bool> read_live(const std::string& text) {
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto live = fields.find("live", Fields::Need::required) ? fields.boolean("live") : std::nullopt;
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return live.value_or(false);
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
