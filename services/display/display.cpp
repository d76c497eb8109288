#include "services/display/display.h"

#include <utility>

#include "services/display/arguments.h"

namespace race::display {

Display::Display(Stage& stage, std::string folder, services::ServiceHost& host)
    : TableComponent(operations(), host), stage_(stage), folder_(std::move(folder)) {}

void Display::call(const services::Call& call) {
  take_happenings();  // what people did before this call comes before it
  TableComponent::call(call);
}

void Display::show(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  auto message = read_message(arguments, folder_);
  if (!message) return refuse_arguments(call, message.error());
  if (auto shown = stage_.show(*target, std::move(*message)); !shown) return refuse_arguments(call, shown.error());
  accept(call);
  host().result(call.id, nullptr);
}

void Display::ask(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  auto question = read_question(arguments);
  if (!question) return refuse_arguments(call, question.error());
  const auto id = stage_.ask(*target, std::move(*question));
  if (!id) return refuse_arguments(call, id.error());
  drop("replaced", "replaced", "another question took its place");
  accept(call);
  waiting_ = Waiting{call.id, *id, call.operation == "choose", {}};
}

void Display::clear(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse_arguments(call, target.error());
  const auto gone = stage_.clear(*target);
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
  take_happenings();
  if (!waiting_) return;
  if (stage_.asking()) {
    waiting_->alone_since.reset();
  } else if (!waiting_->alone_since) {
    waiting_->alone_since = host().now();
  } else if (host().now() - *waiting_->alone_since >= kPatience) {
    stage_.withdraw();
    take_happenings();  // an answer may have come at the last moment
    drop("lost", "display_lost", "no display that shows the question is connected any more");
  }
}

void Display::take_happenings() {
  for (const Happening& happening : stage_.take()) {
    const Value display(happening.display);
    switch (happening.kind) {
      case Happening::Kind::answered:
        answered(happening);
        break;
      case Happening::Kind::pressed:
        host().event("button", Dict{{"button", happening.value}, {"display", display}});
        break;
      case Happening::Kind::connected:
        host().event("connected", Dict{{"display", display}});
        break;
      case Happening::Kind::disconnected:
        host().event("disconnected", Dict{{"display", display}});
        break;
    }
  }
}

// An answer that was on its way when its question was withdrawn comes too late.
void Display::answered(const Happening& happening) {
  if (!waiting_ || waiting_->question != happening.question) return;
  const Waiting waiting = *std::exchange(waiting_, std::nullopt);
  const Value whole = Dict{{"answer", happening.value}, {"display", Value(happening.display)}};
  take("answered");
  host().result(waiting.call, waiting.answer_alone ? happening.value : whole);
  host().event("answer", whole);
}

// The question that waits, if there is one, will not be answered any more.
void Display::drop(std::string_view transition, std::string_view code, std::string_view message) {
  const auto waiting = std::exchange(waiting_, std::nullopt);
  if (!waiting) return;
  take(transition);
  host().error(waiting->call, services::error_value(code, message));
}

}  // namespace race::display
