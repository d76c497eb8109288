#include "server/model_tests/test_of_run.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "core/execution/execution.h"
#include "core/execution/step_json.h"
#include "core/value/json.h"
#include "server/model_tests/any_value.h"

namespace race::server {
namespace {

constexpr double kApart = 0.002;     // s between two inputs, at least
constexpr double kUnknown = 0.01;    // s between them where no times are known
constexpr double kRest = 10;         // s after the last one
constexpr double kTolerance = 1e-9;  // of numbers, which go through a text

// World time passes in milliseconds.
double in_milliseconds(double seconds) { return std::round(seconds * 1000) / 1000; }

struct RecordedCall {
  std::string service, operation;
  double time = 0;
  bool is_read = false;  // some code reads its response: if it had none, nobody could receive it any more
  std::optional<Dict> answer = {};
};

/// JSON with a line for each item of the first `levels` levels; what is deeper stands in its item's line: data may be
/// deep, and its indentation many times as long as it is.
void write_lines(const Value& value, int levels, const std::string& indent, std::string& text) {
  const bool is_dict = value.is_dict();
  const std::size_t size = is_dict ? value.as_dict().size() : value.is_list() ? value.as_list().size() : 0;
  if (levels == 0 || size == 0) {
    text += to_json(value);
    return;
  }
  const std::string inner = indent + "  ";
  const char* separator = "\n";
  text += is_dict ? '{' : '[';
  if (is_dict) {
    for (const auto& [key, item] : value.as_dict()) {
      text += separator + inner + to_json(key) + ": ";
      write_lines(item, levels - 1, inner, text);
      separator = ",\n";
    }
  } else {
    for (const Value& item : value.as_list()) {
      text += separator + inner;
      write_lines(item, levels - 1, inner, text);
      separator = ",\n";
    }
  }
  text += '\n' + indent + (is_dict ? '}' : ']');
}

class Conversion {
 public:
  Conversion(const RecordedRun& run, const std::atomic<bool>* stop) : run_(run), stop_(stop) {}

  Expected<Value> test(const std::string& name) {
    ASSIGN_OR_RETURN(execution::Execution execution, execution::Execution::create(run_.journal.header));
    execution.watch();
    execution.stop_with(stop_);
    for (const execution::JournalEntry& entry : run_.journal.entries) {
      next_time();
      if (auto noted = note_input(entry); !noted) return tl::unexpected(std::move(noted).error());
      ASSIGN_OR_RETURN(const execution::Progress* progress, execution.replay(entry, {.entry = false}));
      note_step(*progress, execution.run().program());
      if (text_ > kMaxTestFile)
        return unexpected(ErrorCode::too_large,
                          "the test would have more than " + std::to_string(kMaxTestFile >> 20U) + " MiB");
    }
    if (!execution.is_over()) return unexpected(ErrorCode::not_accepted, "the run is not over");
    Dict test{{"name", name}};
    if (!run_.journal.header.arguments.empty()) test.set("arguments", run_.journal.header.arguments);
    test.set("limit", std::ceil(time_ + kRest));
    test.set("services", services());
    test.set("expect", expectation(execution));
    return Value(Dict{{"race_test", 1}, {"tests", List{Value(std::move(test))}}});
  }

 private:
  struct Script {
    List answers, events;
    std::set<std::string> drawn;  // operations of which nobody reads a response
  };

  void next_time() {
    const std::size_t number = entries_++;
    if (number == 0) return;  // the start
    const bool is_known = number < run_.times.size();
    const double time = is_known ? run_.times[number] - run_.times[0] : time_ + kUnknown;
    time_ = in_milliseconds(std::max(time, time_ + kApart));
  }

  Expected<void> note_input(const execution::JournalEntry& entry) {
    if (const auto* event = std::get_if<execution::EventEntry>(&entry)) {
      text_ += to_json(event->data).size();
      scripts_[event->service].events.emplace_back(Dict{{"event", event->event}, {"data", event->data}, {"at", time_}});
    } else if (const auto* response = std::get_if<execution::ResponseEntry>(&entry)) {
      const auto call = calls_.find(response->call);
      text_ += to_json(response->data).size();
      if (call != calls_.end())  // else the run does not take it
        call->second.answer = Dict{{"operation", response->operation},
                                   {response->is_error ? "error" : "result", response->data},
                                   {"after", in_milliseconds(time_ - call->second.time)}};
    } else if (!std::holds_alternative<execution::StartEntry>(entry)) {
      return unexpected(ErrorCode::not_accepted, "somebody has edited, forced or aborted the run, as no test can");
    }
    return {};
  }

  void note_step(const execution::Progress& progress, const semantics::Program& program) {
    const List& fired = progress.delta.find("fired")->as_list();
    for (const Value& port : fired) text_ += port.as_string().size();
    order_.insert(order_.end(), fired.begin(), fired.end());
    for (const semantics::OutgoingCall& call : progress.calls) {
      const bool is_read = program.names_response(call.operation);
      calls_.insert_or_assign(call.number, RecordedCall{call.service, call.name, time_, is_read});
      text_ += to_json(call.args).size() + to_json(call.kwargs).size();
      expected_calls_.emplace_back(
          Dict{{"service", call.service}, {"operation", call.name}, {"args", call.args}, {"kwargs", call.kwargs}});
    }
  }

  // The script of each service that the run knew.
  Dict services() {
    for (auto& [number, call] : calls_) {
      Script& script = scripts_[call.service];
      if (call.answer)
        script.answers.emplace_back(std::move(*call.answer));
      else if (call.is_read)
        script.answers.emplace_back(Dict{{"operation", call.operation}, {"never", true}});
      else if (script.drawn.insert(call.operation).second)
        script.answers.emplace_back(drawn_answer(call));
    }
    Dict services;
    for (auto& [key, script] : scripts_) {
      if (!run_.services.contains(key)) continue;
      Dict mock;
      if (!script.answers.empty()) mock.set("answers", std::move(script.answers));
      if (!script.events.empty()) mock.set("events", std::move(script.events));
      services.set(key, std::move(mock));
    }
    return services;
  }

  Dict drawn_answer(const RecordedCall& call) {
    Value result;
    if (const auto service = run_.services.find(call.service); service != run_.services.end()) {
      const auto& all = service->second.operations;
      const auto operation = std::ranges::find(all, call.operation, &rsm::Operation::name);
      if (operation != all.end()) result = any_value(operation->result, random_);
    }
    return {{"operation", call.operation}, {"result", std::move(result)}, {"repeat", true}};
  }

  Dict expectation(const execution::Execution& execution) {
    const semantics::Run& run = execution.run();
    Dict expect;
    if (run.status() == semantics::Status::ended)
      expect.set("outcome", run.outcome());
    else
      expect.set("status", semantics::name(run.status()));
    expect.set("order", std::move(order_));
    expect.set("calls", std::move(expected_calls_));
    expect.set("results", execution::root_results(run));
    expect.set("tolerance", kTolerance);
    return expect;
  }

  const RecordedRun& run_;
  const std::atomic<bool>* stop_;
  std::size_t entries_ = 0;
  double time_ = 0;  // s, of the entry
  std::map<std::uint64_t, RecordedCall> calls_;
  std::map<std::string, Script> scripts_;  // by service
  List order_, expected_calls_;
  std::size_t text_ = 0;  // bytes that these have at least: a run may do more than its inputs say
  Random random_{1};
};

}  // namespace

Checked<std::string> test_of_run(const std::string& name, const RecordedRun& run, const std::atomic<bool>* stop) {
  const auto test = Conversion(run, stop).test(name);
  if (!test) return tl::unexpected(std::vector<Error>{test.error()});
  constexpr int kLevels = 6;  // down to each answer, event and call
  std::string text;
  write_lines(*test, kLevels, "", text);
  text += '\n';
  if (auto file = read_test_text(text); !file) return tl::unexpected(std::move(file).error());
  return text;
}

}  // namespace race::server
