#include "core/execution/checkpoint.h"

#include <cassert>
#include <limits>
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
    auto entry = read_input(items[i], &start);
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

Value model_json(const ExecutedModel& model) {
  Dict json{{"native", model.native}, {"services", interfaces_json(*model.program)}};
  if (model.revision > 0) json.set("revision", model.revision);
  return json;
}

Expected<ExecutedModel> read_model(const Value& json) {
  Errors errors;
  Fields fields(json, "model", "model", errors, Fields::Paths::field);
  const Value* native = fields.find("native", Fields::Need::required);
  const Value* services = fields.find("services", Fields::Need::required);
  if (services && !services->is_dict()) fields.violation(ErrorCode::type, "`services` must be an object", "services");
  const auto revision = fields.integer("revision", 1, std::numeric_limits<std::int64_t>::max());
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  const Interfaces interfaces = read_interfaces(services->as_dict(), "model/services", errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  auto model = build_model(*native, interfaces, "model/native");
  if (!model) return tl::unexpected(std::move(model.error().front()));
  model->revision = revision.value_or(0);
  return std::move(*model);
}

}  // namespace

Value checkpoint_json(const Execution& execution) {
  assert(!execution.is_open());
  Dict checkpoint{
      {"checkpoint", kVersion}, {"run", execution.run().checkpoint_json()}, {"waiting", waiting_json(execution)}};
  if (execution.is_edited()) checkpoint.set("model", model_json(execution.model()));
  Value json = std::move(checkpoint);
  return json.freeze();
}

Expected<Execution> read_checkpoint(const JournalHeader& header, const Value& json) {
  Errors errors;
  Fields fields(json, "", "checkpoint", errors, Fields::Paths::field);
  if (const Value* version = fields.find("checkpoint", Fields::Need::required); version && *version != Value(kVersion))
    return unexpected(ErrorCode::version, "`checkpoint` must be " + std::to_string(kVersion), "checkpoint");
  const Value* run_json = fields.find("run", Fields::Need::required);
  const List& waiting = fields.list("waiting", Fields::Need::required);
  const Value* model_json = fields.find("model");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  ExecutedModel model{header.native, header.program, 0};
  if (model_json) {
    ASSIGN_OR_RETURN(model, read_model(*model_json));
  }
  // The arguments were for the root's parameters at the start (R13).
  auto run = semantics::Run::read_checkpoint(model.program, model_json ? Dict() : header.arguments, header.budgets,
                                             *run_json, "run");
  if (!run) return tl::unexpected(std::move(run.error().front()));
  if (model_json && run->position() < 2)
    return unexpected(ErrorCode::conflict, "a run is edited once it has begun", "model");
  Execution execution(std::move(*run));
  execution.model_ = std::move(model);
  execution.is_edited_ = model_json != nullptr;
  read_waiting(execution, waiting, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  return execution;
}

}  // namespace race::execution
