// POST /api/v1/cores/{id}/force: sets a value, or takes a port of an active state (core/SEMANTICS.md section 9).
#include "core/execution/input_fields.h"
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled force_core(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  auto body = parse_json(request.body);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  semantics::Force force = execution::read_force(fields);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return answer((*core)->force(std::move(force)));
}

}  // namespace race::server
