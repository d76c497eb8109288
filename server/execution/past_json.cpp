#include "server/execution/past_json.h"

#include <utility>

#include "core/value/json.h"
#include "server/execution/waiting_then.h"
#include "services/sqlite/digest.h"

namespace race::server {
namespace {

// Nothing: it is not known. A macro step that has begun and is on its way to the disk has no entry there yet.
Expected<std::optional<std::vector<WaitedInput>>> waited_at(const TimedRun& run, const Moment& moment) {
  WaitingThen waiting(moment);
  const auto read =
      run.runs.timing(run.id, moment.step, run.recent, [&](const TimingBlock& block) { return waiting.take(block); });
  if (!read) return tl::unexpected(read.error());
  auto inputs = waiting.inputs();
  if (!inputs) return inputs;
  ASSIGN_OR_RETURN(const RunRecord record, run.runs.get(run.id));
  for (const WaitedInput& each : *inputs)
    if (each.step > record.steps) inputs.reset();
  return inputs;
}

/// The text of an input as the journal has it or would have it.
Expected<Value> input_of(const TimedRun& run, const WaitedInput& input) {
  if (input.undelivered) return execution::input_json(*input.undelivered);
  ASSIGN_OR_RETURN(const auto entries, run.runs.entries(run.id, input.step, input.step));
  return execution::input_json(entries.front());
}

Expected<Value> waiting_json(const TimedRun& run, const std::vector<WaitedInput>& inputs) {
  List shown;
  std::string all;
  for (const WaitedInput& each : inputs) {
    ASSIGN_OR_RETURN(Value input, input_of(run, each));
    all += to_json(input) + "\n";
    if (shown.size() >= kMostWaitingShown) continue;
    Dict json{{"input", std::move(input)}, {"time", each.time}};
    if (each.step > 0) json.set("step", static_cast<std::int64_t>(each.step));
    shown.emplace_back(std::move(json));
  }
  return Value(Dict{{"count", static_cast<std::int64_t>(inputs.size())},
                    {"inputs", std::move(shown)},
                    {"digest", sqlite::hex(sqlite::sha256(all))}});
}

}  // namespace

Expected<Value> past_json(execution::Replay& replay, std::uint64_t step, int micro, const TimedRun& run,
                          const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(execution::Past past, execution::past(replay, step, micro, stop));
  past.json.set("digest", sqlite::hex(sqlite::sha256(past.text)));
  const Moment moment{step, past.complete ? Moment::kEnd : past.micro};
  ASSIGN_OR_RETURN(const auto waited, waited_at(run, moment));
  if (!waited) return Value(std::move(past.json));
  ASSIGN_OR_RETURN(Value waiting, waiting_json(run, *waited));
  past.json.set("waiting", std::move(waiting));
  return Value(std::move(past.json));
}

}  // namespace race::server
