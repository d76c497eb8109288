#include "core/execution/waiting_inputs.h"

#include <algorithm>
#include <ranges>

namespace race::execution {

using semantics::EventId;
using semantics::Input;
using semantics::Run;

namespace {

bool is_occurrence(const Input& input, EventId event) {
  return input.kind == Input::Kind::event && input.number == event;
}

}  // namespace

bool WaitingInputs::post_event(const Run& run, std::string_view service, std::string_view event, Value data) {
  const EventId id = run.program().services.find_event(service, event);
  return id != semantics::kNone && post_event(run, id, std::move(data));
}

bool WaitingInputs::post_event(const Run& run, EventId event, Value data) {
  Input input = Input::occurrence(event, std::move(data));
  if (!run.counts(input)) return false;
  add(run.program(), std::move(input));
  return true;
}

bool WaitingInputs::post_response(const Run& run, std::uint64_t call, bool is_error, Value data) {
  auto input = run.response(call, is_error, std::move(data));
  if (!input) return false;
  add(run.program(), std::move(*input));
  return true;
}

// REFINEMENT R7
void WaitingInputs::post_lost(const Run& run, std::optional<std::string_view> service) {
  for (const std::uint64_t call : run.unanswered_calls(service))
    post_response(run, call, true, Dict{{"code", "unavailable"}});
}

// REFINEMENT R5: inputs wait in order of arrival; of a sampled event only the newest, at the end.
void WaitingInputs::add(const semantics::Program& program, Input&& input) {
  if (taken_ > 0 && taken_ * 2 >= inputs_.size()) [[unlikely]]
    drop_taken();
  if (input.kind == Input::Kind::event && program.sampled[input.number]) drop_occurrences(input.number);
  inputs_.push_back(std::move(input));
}

// OPTIMIZATION: not in line, as most inputs need neither.
[[gnu::noinline]] void WaitingInputs::drop_taken() {
  inputs_.erase(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(taken_));
  taken_ = 0;
}

[[gnu::noinline]] void WaitingInputs::drop_occurrences(EventId event) {
  const auto waiting = inputs_.begin() + static_cast<std::ptrdiff_t>(taken_);
  const auto same = [event](const Input& input) { return is_occurrence(input, event); };
  inputs_.erase(std::remove_if(waiting, inputs_.end(), same), inputs_.end());
}

// REFINEMENT R5, R6
std::optional<Input> WaitingInputs::take(const Run& run) {
  while (taken_ < inputs_.size()) {
    Input& first = inputs_[taken_++];
    if (first.kind != Input::Kind::event && !run.counts(first)) continue;
    std::optional<Input> input(std::move(first));
    if (taken_ == inputs_.size()) clear();
    return input;
  }
  return std::nullopt;
}

bool WaitingInputs::any(const Run& run) const {
  return std::ranges::any_of(inputs_ | std::views::drop(taken_), [&](const Input& input) { return run.counts(input); });
}

bool WaitingInputs::contains(EventId event) const {
  return std::ranges::any_of(inputs_ | std::views::drop(taken_),
                             [&](const Input& input) { return is_occurrence(input, event); });
}

// core/SEMANTICS.md section 9: "Waiting inputs that M' does not name are dropped."
void WaitingInputs::carry_over(const Run& before, const Run& after) {
  if (&before.program() == &after.program()) return;
  drop_taken();
  std::vector<Input> inputs = std::exchange(inputs_, {});
  const auto& events = before.program().services.events();
  for (Input& input : inputs)
    if (input.kind == Input::Kind::event)
      post_event(after, events[input.number].service, events[input.number].name, std::move(input.data));
    else
      post_response(after, input.call, input.is_error, std::move(input.data));
}

void WaitingInputs::clear() {
  inputs_.clear();
  taken_ = 0;
}

}  // namespace race::execution
