#include "services/display/display.h"

#include <utility>

#include "services/arguments.h"
#include "services/display/arguments.h"

namespace race::display {

Display::Display(Stage& stage, std::string folder, services::ServiceHost& host)
    : host_(host), stage_(stage), folder_(std::move(folder)) {}

void Display::call(const services::Call& call) {
  take();  // what people did before this call comes before it
  const auto arguments = services::bind_arguments(*services::find_operation(model(), call.operation), call);
  if (!arguments) return refuse(call, arguments.error());
  if (call.operation == "clear") return clear(call, *arguments);
  if (call.operation.starts_with("show_")) return show(call, *arguments);
  ask(call, *arguments);
}

void Display::show(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse(call, target.error());
  auto message = read_message(arguments, folder_);
  if (!message) return refuse(call, message.error());
  if (auto shown = stage_.show(*target, std::move(*message)); !shown) return refuse(call, shown.error());
  host_.transition(call.operation + (waiting_ ? "_asking" : ""), call.id);
  host_.result(call.id, nullptr);
}

void Display::ask(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse(call, target.error());
  auto question = read_question(arguments);
  if (!question) return refuse(call, question.error());
  const auto id = stage_.ask(*target, std::move(*question));
  if (!id) return refuse(call, id.error());
  drop("replaced", "replaced", "another question took its place");
  host_.transition(call.operation, call.id);
  waiting_ = Waiting{call.id, *id, call.operation == "choose", {}};
}

void Display::clear(const services::Call& call, const Dict& arguments) {
  const auto target = read_target(arguments);
  if (!target) return refuse(call, target.error());
  const auto gone = stage_.clear(*target);
  if (!gone) return refuse(call, gone.error());
  if (*gone) drop("cleared", "cleared", "the display was cleared");
  host_.transition(waiting_ ? "clear_asking" : "clear", call.id);
  host_.result(call.id, nullptr);
}

void Display::refuse(const services::Call& call, const Error& error) {
  const bool asks = call.operation.starts_with("ask") || call.operation == "choose";
  if (asks && waiting_) {
    host_.transition("refuse_" + call.operation, call.id);
  } else {
    host_.transition(call.operation + (waiting_ ? "_asking" : ""), call.id);
    if (asks) host_.transition("refused");
  }
  const bool absent = error.code == ErrorCode::not_found && error.path == "display";
  Value answer = absent ? services::error_value("no_display", error.message) : services::error_value(error);
  if (!error.path.empty()) answer.mutable_dict().set("argument", Value(error.path));
  host_.error(call.id, std::move(answer));
}

void Display::step() {
  take();
  if (!waiting_) return;
  if (stage_.asking()) {
    waiting_->alone_since.reset();
  } else if (!waiting_->alone_since) {
    waiting_->alone_since = host_.now();
  } else if (host_.now() - *waiting_->alone_since >= kPatience) {
    stage_.withdraw();
    take();  // an answer may have come at the last moment
    drop("lost", "display_lost", "no display that shows the question is connected any more");
  }
}

void Display::take() {
  for (const Happening& happening : stage_.take()) {
    const Value display(happening.display);
    switch (happening.kind) {
      case Happening::Kind::answered:
        answered(happening);
        break;
      case Happening::Kind::pressed:
        host_.event("button", Dict{{"button", happening.value}, {"display", display}});
        break;
      case Happening::Kind::connected:
        host_.event("connected", Dict{{"display", display}});
        break;
      case Happening::Kind::disconnected:
        host_.event("disconnected", Dict{{"display", display}});
        break;
    }
  }
}

// An answer that was on its way when its question was withdrawn comes too late.
void Display::answered(const Happening& happening) {
  if (!waiting_ || waiting_->question != happening.question) return;
  const Waiting waiting = *std::exchange(waiting_, std::nullopt);
  const Value whole = Dict{{"answer", happening.value}, {"display", Value(happening.display)}};
  host_.transition("answered");
  host_.result(waiting.call, waiting.answer_alone ? happening.value : whole);
  host_.event("answer", whole);
}

// The question that waits, if there is one, will not be answered any more.
void Display::drop(std::string_view transition, std::string_view code, std::string_view message) {
  const auto waiting = std::exchange(waiting_, std::nullopt);
  if (!waiting) return;
  host_.transition(transition);
  host_.error(waiting->call, services::error_value(code, message));
}

}  // namespace race::display
