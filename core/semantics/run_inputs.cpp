// The inputs of a run: which count, and how a macro step takes one.
#include <algorithm>
#include <cassert>
#include <ranges>

#include "core/semantics/run_internal.h"
#include "core/semantics/work_set.h"

namespace race::semantics {
namespace {

// The record that a response to call `number` would answer.
// REFINEMENT R6, R20: only the latest call of each caller can be answered, once.
CallRecord* answerable(RunState& run, OperationId operation, std::uint64_t number) {
  for (CallRecord& record : run.calls[operation])
    if (record.number == number && !record.answered) return &record;
  return nullptr;
}

const std::string& callee(const Program& program, OperationId operation, const CallRecord& record) {
  return program.services.is_open(operation) ? record.service : program.services.operations()[operation].service;
}

}  // namespace

std::uint64_t Run::find_call(std::string_view service, std::string_view operation, std::uint64_t number) const {
  const OperationId id = body_->program->services.dynamic_operation(service, operation);
  if (id == kNone) return 0;
  for (const CallRecord& record : std::views::reverse(body_->state.calls[id]))
    if (callee(*body_->program, id, record) == service && (number == 0 || record.number == number))
      return record.number;
  return 0;
}

std::optional<Input> Run::response(std::uint64_t number, bool is_error, Value data) const {
  for (OperationId o = 0; o < body_->state.calls.size(); ++o) {
    if (!answerable(body_->state, o, number)) continue;
    Input input{Input::Kind::response, o, number, is_error, std::move(data)};
    return counts(input) ? std::optional(std::move(input)) : std::nullopt;
  }
  return std::nullopt;
}

bool Run::counts(const Input& input) const {
  if (body_->status != Status::running) return false;
  if (input.kind == Input::Kind::event) return body_->program->names_event(input.number);
  return body_->program->names_response(input.number) && answerable(body_->state, input.number, input.call);
}

const std::string& Run::service_of(const Input& response) const {
  const CallRecord* record = answerable(body_->state, response.number, response.call);
  assert(record);
  return callee(*body_->program, response.number, *record);
}

std::vector<std::uint64_t> Run::unanswered_calls(std::optional<std::string_view> service) const {
  std::vector<std::uint64_t> unanswered;
  for (OperationId o = 0; o < body_->state.calls.size(); ++o)
    for (const CallRecord& record : body_->state.calls[o])
      if (!record.answered && (!service || callee(*body_->program, o, record) == *service))
        unanswered.push_back(record.number);
  std::ranges::sort(unanswered);
  return unanswered;
}

std::uint64_t Run::service_data_units() const {
  std::uint64_t units = 0;
  for (const Value& data : body_->state.event_data) units += data.size_units();
  for (const auto& records : body_->state.calls)
    for (const CallRecord& record : records) units += record.response.size_units();
  return units;
}

// Macro (4.19): the snapshot, then quiescence (Run::quiesce).
//
//   Σ' = Ω if updated(Ω,Σ), else Σ    Σ' ⊢ Δ ⟹↓ε Δ',Ω'
//   ───────────────────────────────────────────────────
//   Ω ⊢ (Σ,Δ) ∗→ (Σ',Δ'),Ω'
//
// REFINEMENT R5: an input is the update. REFINEMENT R15: missing requirements ε do not block it.
void Run::begin(std::optional<Input>&& input) {
  assert(body_->status == Status::running);
  RunState& run = body_->state;
  const Program& program = *body_->program;
  body_->micro_steps = 0;
  body_->environment.use = {};
  ++body_->position;
  run.forced = kNoPort;
  if (!input) return;
  ++run.epoch;  // `executed`, `triggered` and the states activated in this macro step are empty
  const bool active = run.flags[program.flag(Program::root)] != 0;
  for (const StateId s : run.recheck) {
    run.live[index(s)].recheck = false;
    if (run.flags[program.flag(s)]) mark_dirty(run, s);
  }
  run.recheck.clear();
  const EventId before = std::exchange(run.occurrence, kNone);
  if (input->kind == Input::Kind::event) {
    run.occurrence = input->number;
    run.event_data[input->number] = std::move(input->data);
    run.event_tick[input->number] = ++run.tick;
    if (active) mark_event_readers(run, program, input->number);
  } else {
    CallRecord* record = answerable(run, input->number, input->call);
    assert(record);
    record->answered = true;
    record->is_error = input->is_error;
    record->response = std::move(input->data);
    run.response_tick[input->number] = ++run.tick;
    if (active) mark_response_readers(run, program, input->number);
  }
  if (active && before != kNone && before != run.occurrence) mark_event_readers(run, program, before);
}

}  // namespace race::semantics
