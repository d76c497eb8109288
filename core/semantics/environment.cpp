#include "core/semantics/environment.h"

#include <algorithm>
#include <ranges>

namespace race::semantics {
namespace {

const Value kUnknown = Value::unknown();

const Value& shown(const CallRecord& record, bool error) {
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
    if (record.service == service) return shown(record, error);
  }
  return kUnknown;
}

void StepEnvironment::write(Slot slot, Value value) {
  const std::uint8_t readers = program_.slot_readers[slot];
  const StateId owner = program_.slot_state[slot];
  if (readers & kOwner) wake(run_, owner);
  if (readers & kParent) wake(run_, program_[owner].parent);
  log_.emplace_back(slot, std::move(run_.values[slot]));
  run_.values[slot] = std::move(value);
}

void StepEnvironment::call(OperationId operation, std::string_view service, std::string_view name, List args,
                           Dict kwargs) {
  if (record) record->parts.push_back({Rule::FuncSC, NodeValue::none, static_cast<std::uint32_t>(calls.size())});
  calls.push_back({operation, std::string(service), std::string(name), std::move(args), std::move(kwargs)});
}

}  // namespace race::semantics
