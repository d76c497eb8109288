// Tools of what a run has done: the derivations of its macro steps, and why a port fired or does not fire.
#include <algorithm>

#include "core/value/json.h"
#include "server/mcp/tool.h"

namespace race::server::mcp {
namespace {

constexpr std::int64_t kSteps = 10;            // of an answer, if nothing else is asked for
constexpr std::size_t kBytes = kMostText / 2;  // of their text

const List kNoSteps;

const List& steps_of(const Value& answer) {
  const Value* steps = answer.find("steps");
  return steps && steps->is_list() ? steps->as_list() : kNoSteps;
}

Problem too_long(std::int64_t step) {
  return make_problem({ErrorCode::too_large,
                       "the derivation of macro step " + std::to_string(step) +
                           " has more text than an answer; read it "
                           "on a page of the server, or with `race replay`",
                       "from"});
}

// Of a core or a stored run: how many macro steps it has.
std::int64_t count_steps(const Value& run) {
  for (const char* key : {"step", "steps"})
    if (const Value* count = run.find(key); count && count->is_integer()) return count->as_integer();
  return 0;
}

// As many of the steps, the first being `from`, as fit into an answer; and where the next answer begins, if the run has
// more.
Outcome fitting(Value answer, std::int64_t from, std::int64_t steps) {
  std::size_t bytes = 0;
  List fit;
  for (const Value& step : steps_of(answer)) {
    bytes += to_json(step).size();
    if (bytes > kBytes) break;
    fit.push_back(step);
  }
  if (fit.empty() && !steps_of(answer).empty()) return tl::unexpected(too_long(from));
  const std::int64_t next = from + std::ssize(fit);
  if (!fit.empty() && next <= steps) answer.mutable_dict().set("next", next);
  answer.mutable_dict().set("steps", std::move(fit));
  return answer;
}

}  // namespace

// Without `from`, the last step. The server refuses a range that the run does not have, so that its end is asked for
// first.
Outcome read_derivations(const Context& context, const Dict& arguments) {
  const std::string& run = text_of(arguments, "run");
  const auto status = get_of_run(context, run);
  if (!status) return status;
  const std::int64_t steps = count_steps(*status);
  const Value* first = arguments.find("from");
  const Value* most = arguments.find("limit");
  const std::int64_t from = first ? first->as_integer() : steps;
  const std::int64_t limit = most ? most->as_integer() : kSteps;
  auto answer = get_of_run(context, run, "derivations", [&](Target& target) {
    const Value begin(from), end(from > steps ? from : from + std::min(limit - 1, steps - from));
    if (from > 0) target.with("from", &begin).with("to", &end);
  });
  if (!answer || !answer->is_dict()) return answer;
  return fitting(std::move(*answer), from, steps);
}

Outcome explain_port(const Context& context, const Dict& arguments) {
  return get_of_run(context, text_of(arguments, "run"), "why", [&](Target& target) {
    for (const char* name : {"port", "state", "action", "parameter", "step", "micro"})
      target.with(name, arguments.find(name));
  });
}

}  // namespace race::server::mcp
