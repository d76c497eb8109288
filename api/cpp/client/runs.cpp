#include "api/cpp/client/runs.h"

#include <algorithm>

#include "api/cpp/client/answer_internal.h"
#include "api/cpp/client/calls.h"

namespace race::client {

Answered<List> all_runs(const Client& client, const std::optional<std::string>& document) {
  List all;
  for (std::optional<std::int64_t> before;;) {
    ASSIGN_OR_RETURN(const Value page, client.send(calls::list_runs({.document = document, .before = before})));
    ASSIGN_OR_RETURN(const List runs, list_in(page, "runs"));
    all.insert(all.end(), runs.begin(), runs.end());
    const Value* const next = page.find("next");
    if (!next || !next->is_integer()) return all;
    before = next->as_integer();
  }
}

Answered<List> run_derivations(const Client& client, std::string_view run, std::int64_t first,
                               std::optional<std::int64_t> last) {
  constexpr std::int64_t kPage = 100;  // macro steps of an answer, at most (openapi.yaml)
  if (!last) {
    ASSIGN_OR_RETURN(const Value stored, client.send(calls::get_run(run)));
    ASSIGN_OR_RETURN(last, integer_in(stored, "steps"));
  }
  List all;
  while (first <= *last) {
    const std::int64_t end = std::min(*last, first + kPage - 1);
    ASSIGN_OR_RETURN(const Value page, client.send(calls::get_run_derivations(run, {.from = first, .to = end})));
    ASSIGN_OR_RETURN(const List steps, list_in(page, "steps"));
    if (steps.empty()) return all;
    all.insert(all.end(), steps.begin(), steps.end());
    ASSIGN_OR_RETURN(const std::int64_t reached, integer_in(steps.back(), "step"));
    first = std::max(reached, first) + 1;
  }
  return all;
}

}  // namespace race::client
