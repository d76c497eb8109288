#include "core/execution/past.h"

#include <utility>

#include "core/execution/step_json.h"
#include "core/value/json.h"

namespace race::execution {

namespace {

Value count_value(std::uint64_t n) { return static_cast<std::int64_t>(n); }

// Those that nobody has answered yet, in order of call.
List open_calls(const List& calls) {
  List open;
  for (const Value& call : calls)
    if (!call.find("result") && !call.find("error")) open.push_back(call);
  return open;
}

List list_of(const Value& json, std::string_view key) {
  const Value* list = json.find(key);
  return list ? list->as_list() : List{};
}

}  // namespace

std::string moment_text(const Execution& execution) {
  return to_json(Dict{{"micro", count_value(execution.micro_steps())}, {"run", execution.run().checkpoint_json()}});
}

// A macro step ends with a micro step that changes nothing: whether it comes next is seen by doing it.
Expected<Past> past(Replay& replay, std::uint64_t step, int micro, const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution then, replay.before(step, micro, stop));
  const std::uint32_t done = then.micro_steps();
  bool complete = !then.is_open();
  if (!complete) {
    Execution ahead = then;
    ahead.continue_step(1);
    complete = ahead.micro_steps() == done && !ahead.is_over();
  }
  const Value run = then.run().checkpoint_json();
  Past past;
  past.json = Dict{{"step", count_value(step)}, {"micro", count_value(done)}, {"complete", complete}};
  set_status(then.run(), past.json);
  past.json.set("state", then.run().state_json());
  past.json.set("events", list_of(run, "events"));
  past.json.set("open_calls", open_calls(list_of(run, "calls")));
  past.text = moment_text(then);
  past.micro = done;
  past.complete = complete;
  return past;
}

}  // namespace race::execution
