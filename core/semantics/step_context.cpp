#include "core/semantics/step_context.h"

namespace race::semantics {

// The responses to the caller's older calls of the same operation are gone (R6).
void StepContext::send(StateId s, BufferedCall call) {
  const std::uint64_t number = ++run.call_count;
  LoggedCall logged{call.operation, 0, std::nullopt};
  std::vector<CallRecord>& records = run.calls[call.operation];
  const std::string whose = program.services.is_open(call.operation) ? call.service : std::string();
  const auto old = std::ranges::find_if(
      records, [&](const CallRecord& record) { return record.caller == s && record.service == whose; });
  std::uint64_t supersedes = 0;
  if (old != records.end()) {
    if (!old->answered) supersedes = old->number;
    logged.place = static_cast<std::size_t>(old - records.begin());
    logged.before = std::move(*old);
    records.erase(old);
  }
  records.push_back({s, whose, number});
  mark_response_readers(run, program, call.operation);
  work.log.calls.push_back(std::move(logged));
  work.outgoing.push_back({number, call.operation, std::move(call.service), std::move(call.name), std::move(call.args),
                           std::move(call.kwargs), s, supersedes});
}

}  // namespace race::semantics
