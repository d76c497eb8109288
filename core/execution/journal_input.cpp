#include "core/execution/journal_input.h"

namespace race::execution {

using semantics::EventId;
using semantics::Input;
using semantics::Run;

JournalEntry entry_of(const Run& run, Input& input) {
  input.data.freeze();
  const language::ServiceTable& services = run.program().services;
  if (input.kind == Input::Kind::event) {
    const auto& event = services.events()[input.number];
    return EventEntry{event.service, event.name, input.data};
  }
  return ResponseEntry{input.call, run.service_of(input), services.operations()[input.number].name, input.is_error,
                       input.data};
}

namespace {

tl::unexpected<Error> not_taken(const std::string& what) {
  return unexpected(ErrorCode::conflict, "the run takes no " + what + " here: the journal is of another run");
}

Expected<Input> input_of(const Run& run, const EventEntry& entry) {
  const EventId event = run.program().services.find_event(entry.service, entry.event);
  Input input = Input::occurrence(event, entry.data);
  if (event == semantics::kNone || !run.counts(input)) return not_taken("event " + entry.service + "." + entry.event);
  return input;
}

Expected<Input> input_of(const Run& run, const ResponseEntry& entry) {
  auto input = run.response(entry.call, entry.is_error, entry.data);
  if (!input || run.find_call(entry.service, entry.operation, entry.call) != entry.call)
    return not_taken("response of " + entry.service + "." + entry.operation + " to call " + std::to_string(entry.call));
  return std::move(*input);
}

}  // namespace

Expected<Input> input_of(const Run& run, const JournalEntry& entry) {
  if (const auto* event = std::get_if<EventEntry>(&entry)) return input_of(run, *event);
  if (const auto* response = std::get_if<ResponseEntry>(&entry)) return input_of(run, *response);
  return not_taken("input of this kind");
}

}  // namespace race::execution
