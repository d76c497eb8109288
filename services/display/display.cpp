#include "services/display/display.h"

#include <utility>

#include "services/display/arguments.h"

namespace race::display {

Display::Display(DisplayBackend& backend, std::string folder, services::ServiceHost& host)
    : TableComponent(operations(), host), backend_(backend), folder_(std::move(folder)) {}

void Display::call(const services::Call& call) {
  take_events();  // input from before the call comes first
  TableComponent::call(call);
}

void Display::show(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  auto message = read_message(arguments, folder_);
  if (!message) return refuse_arguments(call, message.error());
  if (auto shown = backend_.show(*target, std::move(*message)); !shown) return refuse_arguments(call, shown.error());
  accept(call);
  host().result(call.id, nullptr);
}

void Display::ask(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  auto question = read_question(arguments);
  if (!question) return refuse_arguments(call, question.error());
  const auto id = backend_.ask(*target, std::move(*question));
  if (!id) return refuse_arguments(call, id.error());
  drop("replaced", "replaced", "another question took its place");
  accept(call);
  pending_ = PendingQuestion{call.id, *id, call.operation == "choose", {}};
}

void Display::clear(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  const auto gone = backend_.clear(*target);
  if (!gone) return refuse_arguments(call, gone.error());
  if (*gone) drop("cleared", "cleared", "the display was cleared");
  accept(call);
  host().result(call.id, nullptr);
}

void Display::refuse_arguments(const services::Call& call, const Error& error) {
  const bool absent = error.code == ErrorCode::not_found && error.path == "display";
  if (!absent) return TableComponent::refuse_arguments(call, error);
  Value answer = services::error_value("no_display", error.message);
  answer.mutable_dict().set("argument", Value(error.path));
  refuse(call, std::move(answer));
}

void Display::step() {
  take_events();
  if (!pending_) return;
  if (backend_.asking()) {
    pending_->disconnected_since.reset();
  } else if (!pending_->disconnected_since) {
    pending_->disconnected_since = host().now();
  } else if (host().now() - *pending_->disconnected_since >= kReconnectTimeout) {
    backend_.withdraw();
    take_events();  // an answer may have come at the last moment
    drop("lost", "display_lost", "no display that shows the question is connected any more");
  }
}

void Display::take_events() {
  for (const DisplayEvent& event : backend_.take()) {
    const Value display(event.display);
    switch (event.kind) {
      case DisplayEvent::Kind::answered:
        answered(event);
        break;
      case DisplayEvent::Kind::pressed:
        host().event("button", Dict{{"button", event.value}, {"display", display}});
        break;
      case DisplayEvent::Kind::connected:
        host().event("connected", Dict{{"display", display}, {"place", Value(event.place)}});
        break;
      case DisplayEvent::Kind::disconnected:
        host().event("disconnected", Dict{{"display", display}, {"place", Value(event.place)}});
        break;
    }
  }
}

// An answer to a question that was withdrawn meanwhile is ignored.
void Display::answered(const DisplayEvent& event) {
  if (!pending_ || pending_->question != event.question) return;
  const PendingQuestion pending = *std::exchange(pending_, std::nullopt);
  const Value whole = Dict{{"answer", event.value}, {"display", Value(event.display)}};
  take("answered");
  host().result(pending.call, pending.answer_only ? event.value : whole);
  host().event("answer", whole);
}

// Ends the question that waits, if there is one, with an error.
void Display::drop(std::string_view transition, std::string_view code, std::string_view message) {
  const auto pending = std::exchange(pending_, std::nullopt);
  if (!pending) return;
  take(transition);
  host().error(pending->call, services::error_value(code, message));
}

}  // namespace race::display
