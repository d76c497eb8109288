#include "core/semantics/why.h"

#include <algorithm>
#include <utility>

#include "core/semantics/run_internal.h"
#include "core/semantics/step_context.h"

namespace race::semantics {

using language::Truth;

namespace {

/// What lets the action run again (R19), as code names it.
std::vector<std::string> awaited_by(const Program& program, const ActionInfo& action) {
  std::vector<std::string> texts;
  for (const EventId e : action.events) {
    const auto& event = program.services.events()[e];
    texts.push_back("svc." + event.service + "." + event.name);
  }
  for (const OperationId o : action.responses) {
    const auto& operation = program.services.operations()[o];
    texts.push_back(operation.open ? "svc[...]." + operation.name : "svc." + operation.service + "." + operation.name);
  }
  return texts;
}

/// Explains a subject at its first turn in a micro step of `run`.
class WhyWatch final : public TurnWatch {
 public:
  WhyWatch(Run& run, const Subject& subject) : run_(run), subject_(subject) {}

  void port(PortId p) override {
    const auto* asked = std::get_if<PortId>(&subject_);
    if (asked && *asked == p) explain();
  }
  void action(ActionId a) override {
    const auto* asked = std::get_if<ActionOf>(&subject_);
    if (asked && run_.program()[asked->state].actions.low + asked->number == a) explain();
  }
  void parameter(StateId s, std::uint32_t number) override {
    const auto* asked = std::get_if<ParameterOf>(&subject_);
    if (asked && asked->state == s && asked->number == number) explain();
  }
  std::optional<Why> take() { return std::move(made_); }

 private:
  void explain() {
    if (!made_) made_ = run_.why(subject_);
  }

  Run& run_;
  const Subject& subject_;
  std::optional<Why> made_;
};

}  // namespace

WhyPort Run::why_port(PortId port) {
  Body& b = *body_;
  const PortInfo& info = (*b.program)[port];
  WhyPort why{.port = port};
  why.state_active = is_active(info.state);
  why.active = b.state.flags[b.program->flag(port)] != 0;
  why.occurrence_hidden = is_occurrence_hidden(info.state);
  const StepContext context(*b.program, b.state, b.work);
  why.forced = b.state.forced == port && why.state_active && context.ports_see_occurrence(info.state);
  b.environment.enter(info.state, !why.occurrence_hidden);
  why.explanation = language::explain(info.when, b.environment);
  why.held_back = info.svc && b.state.triggered[index(port)] == b.state.epoch && why.explanation.value == Truth::yes;
  return why;
}

WhyAction Run::why_action(ActionOf subject) {
  Body& b = *body_;
  const auto [state, number] = subject;
  const ActionId a = (*b.program)[state].actions.low + number;
  const ActionInfo& action = b.program->actions[a];
  const StepContext context(*b.program, b.state, b.work);
  WhyAction why{.action = subject};
  why.state_active = is_active(state);
  why.executed = context.is_executed(a);
  why.served = action.served && !context.is_delivered_anew(state, a);
  why.level = action.level;
  if (action.served) why.awaited = awaited_by(*b.program, action);
  b.environment.enter(state, true);
  why.explanation = language::explain(action.when, b.environment);
  if (why.state_active && !why.executed && !why.served && why.explanation.value == Truth::yes)
    why.unmet = unmet(subject);
  return why;
}

// The function is executed on a copy of the run, to see.
std::optional<language::Fault> Run::unmet(ActionOf subject) const {
  Run ahead(*this);
  Body& b = *ahead.body_;
  const Code& code = b.program->actions[(*b.program)[subject.state].actions.low + subject.number].code;
  b.environment.enter(subject.state, true);
  if (b.interpreter.function(code, b.environment) == language::Interpreter::Outcome::done) return {};
  return b.interpreter.fault();
}

WhyParameter Run::why_parameter(ParameterOf subject) {
  Body& b = *body_;
  const StateInfo& state = (*b.program)[subject.state];
  const ParameterInfo& info = state.parameters[subject.number];
  WhyParameter why{.parameter = subject};
  why.state_active = is_active(subject.state);
  why.value = b.state.values[state.first_parameter + subject.number];
  if (subject.state == Program::root && subject.number < b.arguments.size() &&
      !b.arguments[subject.number].is_unknown())
    why.argument = b.arguments[subject.number];
  else if (info.value)
    why.constant = *info.value;
  else if (info.from) {
    b.environment.enter(state.parent, false);
    why.expression = language::explain_value(info.from, b.environment);
  }
  return why;
}

Why Run::why(const Subject& subject) {
  if (const auto* port = std::get_if<PortId>(&subject)) return why_port(*port);
  if (const auto* action = std::get_if<ActionOf>(&subject)) return why_action(*action);
  return why_parameter(std::get<ParameterOf>(subject));
}

// The micro step is done on a copy of the run. If it changes nothing, there is none, and things are as they stand.
std::optional<Why> Run::why_at_turn(const Subject& subject) const {
  Run ahead(*this);
  WhyWatch watch(ahead, subject);
  TreeRecorder trees;
  trees.watch = &watch;
  if (!ahead.micro(trees) && ahead.status() == Status::running) return {};
  return watch.take();
}

}  // namespace race::semantics
