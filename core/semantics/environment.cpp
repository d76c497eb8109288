#include "core/semantics/environment.h"

#include <algorithm>
#include <ranges>

#include "core/semantics/work_set.h"

namespace race::semantics {
namespace {

const Value kUnknown = Value::unknown();

const Value& visible_response(const CallRecord& record, bool error) {
  return record.answered && record.is_error == error ? record.response : kUnknown;
}

}  // namespace

// REFINEMENT R6, R20: if code of the state or of a descendant calls the operation, the response to the latest such call
// since the state was activated counts; otherwise the one to the latest call of anyone.
const Value& StepEnvironment::response(OperationId operation, std::string_view service, bool error) {
  const auto made_here = [&](const BufferedCall& call) {
    return call.operation == operation && (call.service == service || !program_.services.is_open(operation));
  };
  if (std::ranges::any_of(calls, made_here)) return kUnknown;
  const StateInfo& info = program_[state_];
  const bool own = std::ranges::binary_search(info.calls, operation);
  const std::uint64_t before = own ? run_.live[index(state_)].calls_before : 0;
  for (const CallRecord& record : std::views::reverse(run_.calls[operation])) {
    if (record.number <= before) break;
    if (own && (index(record.caller) < index(state_) || index(record.caller) >= info.end)) continue;
    if (record.service == service) return visible_response(record, error);
  }
  return kUnknown;
}

void StepEnvironment::write(ValueIndex at, Value value) {
  const std::uint8_t readers = program_.value_readers[at];
  const StateId owner = program_.value_owner[at];
  if (readers & kOwner) mark_dirty(run_, owner);
  if (readers & kParent) mark_dirty(run_, program_[owner].parent);
  log_.emplace_back(at, std::move(run_.values[at]));
  run_.values[at] = std::move(value);
}

void StepEnvironment::count_calls() {
  use.calls += calls.size();
  for (const BufferedCall& call : calls) {
    for (const Value& each : call.args) use.output_units += each.size_units();
    for (const auto& [name, each] : call.kwargs) use.output_units += each.size_units();
  }
}

std::string StepEnvironment::exceeded_budget() const {
  const auto more_than = [](std::uint64_t most, const char* of_what) {
    return "more than " + std::to_string(most) + " " + of_what + " in one macro step";
  };
  if (use.work > budgets.work) return more_than(budgets.work, "steps");
  if (use.calls > budgets.calls) return more_than(budgets.calls, "calls");
  return more_than(budgets.output_units, "units called with and printed");
}

void StepEnvironment::call(OperationId operation, std::string_view service, std::string_view name, List args,
                           Dict kwargs) {
  evaluation.statements.push_back({Statement::Kind::service_call, calls.size()});
  calls.push_back({operation, std::string(service), std::string(name), std::move(args), std::move(kwargs)});
}

}  // namespace race::semantics
