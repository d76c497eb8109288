// GET /api/v1/cores/{id}/why?port=&step=&micro=: why a port does not fire now, or why it fired in a past micro step.
#include <charconv>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

// A number of the query that is at least `least`.
Expected<int> number_of(const Request& request, std::string_view name, int least) {
  const auto found = request.query.find(name);
  if (found == request.query.end())
    return unexpected(ErrorCode::missing, "`step` and `micro` go together", std::string(name));
  const std::string& text = found->second;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < least)
    return unexpected(ErrorCode::out_of_range, "must be a number from " + std::to_string(least), std::string(name));
  return number;
}

}  // namespace

Handled get_why(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const auto port = request.query.find("port");
  if (port == request.query.end()) return failed({ErrorCode::missing, "which port? ?port=Root/A.success", "port"});
  if (!request.query.contains("step") && !request.query.contains("micro")) return answer((*core)->why(port->second));
  const auto step = number_of(request, "step", 1), micro = number_of(request, "micro", 0);
  if (!step) return failed(step.error());
  if (!micro) return failed(micro.error());
  return answer((*core)->why_before(port->second, static_cast<std::size_t>(*step), *micro));
}

}  // namespace race::server
