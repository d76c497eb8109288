// Tools of runs: cores that execute a document, and what is stored of them.
#include <algorithm>
#include <chrono>
#include <thread>

#include "core/value/json.h"
#include "server/mcp/tool.h"
#include "server/wire/run_status.h"

namespace race::server::mcp {
namespace {

using Steady = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kLook = 200ms;   // between two looks at a run
constexpr auto kPause = 20ms;   // until it is seen that a call is cancelled
constexpr auto kTell = 1s;      // between two tellings of progress
constexpr int kUsualWait = 30;  // s

std::string status_of(const Value& core) {
  const Value* status = core.find("status");
  return status && status->is_string() ? status->as_string() : std::string();
}

// Nothing happens any more, or not before somebody lets it go on.
bool stands(const Value& core) {
  const Value* paused = core.find("paused");
  const std::string status = status_of(core);
  return status != "running" || (paused && paused->is_bool() && paused->as_bool());
}

bool is_over(const Value& core) { return server::is_over(status_of(core)); }

std::string line_of(const Value& core) {
  const Value* step = core.find("step");
  return status_of(core) + ", macro step " + (step ? to_json(*step) : std::string("?"));
}

Value seen(Value core) {
  const bool over = is_over(core);
  return Dict{{"over", over}, {"run", std::move(core)}};
}

void pause(const Stop& cancelled, Steady::time_point end) {
  while (!cancelled && Steady::now() < end)
    std::this_thread::sleep_for(std::min<Steady::duration>(kPause, end - Steady::now()));
}

void remove_core(const Context& context, const std::string& id) {
  static_cast<void>(context.api.ask("DELETE", Target{"cores", id}));
}

double seconds_since(Steady::time_point begin) { return std::chrono::duration<double>(Steady::now() - begin).count(); }

}  // namespace

Outcome get_of_run(const Context& context, const std::string& run, std::string_view below,
                   const std::function<void(Target&)>& query) {
  const auto get = [&](std::string_view kind) {
    Target target = below.empty() ? Target{kind, run} : Target{kind, run, below};
    query(target);
    return context.api.get(target);
  };
  auto of_core = get("cores");
  if (of_core || of_core.error().status != 404) return of_core;
  auto of_run = get("runs");
  return of_run || of_run.error().status != 404 ? of_run : of_core;
}

Outcome list_cores(const Context& context, const Dict&) { return context.api.get(Target{"cores"}); }

// A core that may not begin, or is wanted no more, is removed: it would wait for somebody who does not know of it.
Outcome start_run(const Context& context, const Dict& arguments) {
  Dict body{{"document", *arguments.find("document")}};
  if (const Value* given = arguments.find("arguments")) body.set("arguments", *given);
  const auto core = context.api.post(Target{"cores"}, body);
  if (!core) return core;
  const Value* id = core->find("id");
  if (!id || !id->is_string())
    return tl::unexpected(make_problem({ErrorCode::io, "the server answers what is no core"}));
  if (context.cancelled) {
    remove_core(context, id->as_string());
    return core;
  }
  auto started = context.api.post(Target{"cores", id->as_string(), "start"});
  if (!started && started.error().status != 0)
    remove_core(context, id->as_string());
  else if (!started)
    started.error().errors.set("run", *id);  // it may have begun
  return started;
}

Outcome run_status(const Context& context, const Dict& arguments) {
  const std::string& run = text_of(arguments, "run");
  const Value* values = arguments.find("values");
  if (values && values->as_bool()) return context.api.get(Target{"cores", run, "state"});
  return get_of_run(context, run);
}

Outcome wait_for_run(const Context& context, const Dict& arguments) {
  const Value* given = arguments.find("seconds");
  const double seconds = given ? given->to_double() : kUsualWait;
  const auto begin = Steady::now();
  const auto end = begin + std::chrono::duration_cast<Steady::duration>(std::chrono::duration<double>(seconds));
  auto next_telling = begin;
  for (;;) {
    auto core = get_of_run(context, text_of(arguments, "run"));
    if (!core) return core;
    const auto now = Steady::now();
    if (stands(*core) || now >= end || context.cancelled) return seen(std::move(*core));
    if (now >= next_telling) {
      context.tell_progress(seconds_since(begin), seconds, line_of(*core));
      next_telling = now + kTell;
    }
    pause(context.cancelled, std::min(now + kLook, end));
  }
}

Outcome stop_run(const Context& context, const Dict& arguments) {
  return context.api.post(Target{"cores", text_of(arguments, "run"), "stop"});
}

Outcome list_runs(const Context& context, const Dict& arguments) {
  Target target{"runs"};
  for (const char* name : {"document", "before", "limit"}) target.with(name, arguments.find(name));
  return context.api.get(target);
}

}  // namespace race::server::mcp
