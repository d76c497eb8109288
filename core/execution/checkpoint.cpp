#include "core/execution/checkpoint.h"

#include <cassert>
#include <utility>

#include "core/execution/journal_input.h"
#include "core/value/fields.h"

namespace race::execution {
namespace {

using Errors = std::vector<Error>;

/// Of this form of a checkpoint. It changes when another build could not go on from one.
constexpr std::int64_t kVersion = 1;

// What waits and still counts: the rest has no effect.
List waiting_json(const Execution& execution) {
  List waiting;
  for (semantics::Input input : execution.waiting().inputs())
    if (execution.run().counts(input)) waiting.push_back(input_json(entry_of(execution.run(), input)));
  return waiting;
}

bool post(Execution& execution, const JournalEntry& entry) {
  const std::size_t before = execution.waiting().size();
  if (!input_of(execution.run(), entry)) return false;
  if (const auto* event = std::get_if<EventEntry>(&entry))
    execution.post_event(event->service, event->event, event->data);
  else if (const auto* response = std::get_if<ResponseEntry>(&entry))
    execution.post_response(response->call, response->is_error, response->data);
  return execution.waiting().size() == before + 1;  // of a sampled event one waits
}

void read_waiting(Execution& execution, const List& items, Errors& errors) {
  const JournalEntry start = StartEntry{};
  for (std::size_t i = 0; i < items.size() && errors.empty(); ++i) {
    const std::string path = "waiting/" + std::to_string(i);
    auto entry = read_input(items[i], &start, execution.run().program());
    if (!entry) {
      for (Error& error : entry.error()) {
        error.path.replace(0, std::string_view("input").size(), path);
        errors.push_back(std::move(error));
      }
    } else if (!post(execution, *entry)) {
      errors.push_back({ErrorCode::conflict, "the run does not take this input", path});
    }
  }
}

}  // namespace

Value checkpoint_json(const Execution& execution) {
  assert(!execution.is_open());
  Value json =
      Dict{{"checkpoint", kVersion}, {"run", execution.run().checkpoint_json()}, {"waiting", waiting_json(execution)}};
  return json.freeze();
}

Expected<Execution> read_checkpoint(const JournalHeader& header, const Value& json) {
  Errors errors;
  Fields fields(json, "", "checkpoint", errors, Fields::Paths::field);
  if (const Value* version = fields.find("checkpoint", Fields::Need::required); version && *version != Value(kVersion))
    return unexpected(ErrorCode::version, "`checkpoint` must be " + std::to_string(kVersion), "checkpoint");
  const Value* run_json = fields.find("run", Fields::Need::required);
  const List& waiting = fields.list("waiting", Fields::Need::required);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  auto run = semantics::Run::read_checkpoint(header.program, header.arguments, header.budgets, *run_json, "run");
  if (!run) return tl::unexpected(std::move(run.error().front()));
  Execution execution(std::move(*run));
  read_waiting(execution, waiting, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  return execution;
}

}  // namespace race::execution
