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

Handled set_core_live(const Request& request, Cores& cores, LiveEdits& edits) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const auto live = read_live(request.body);
  if (!live) return tl::unexpected(live.error());
  auto changed = (*core)->set_live(*live);
  if (changed && *live) edits.changed(changed->find("document")->as_string());
  return answer(std::move(changed));
}

}  // namespace race::server
