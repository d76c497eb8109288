// GET /api/v1/cores/{id}/derivations?from&to: recomputed from the journal.
#include <charconv>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

// A macro step of the query; 0 if it is absent.
Expected<std::size_t> step_of(const Request& request, std::string_view name) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return 0U;
  const std::string& text = found->second;
  std::size_t step = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), step);
  if (error != std::errc() || end != text.data() + text.size() || step == 0)
    return unexpected(ErrorCode::out_of_range, "must be the number of a macro step, from 1", std::string(name));
  return step;
}

}  // namespace

Handled get_derivations(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const auto from = step_of(request, "from"), to = step_of(request, "to");
  if (!from) return failed(from.error());
  if (!to) return failed(to.error());
  return answer((*core)->derivations(*from, *to));
}

}  // namespace race::server
