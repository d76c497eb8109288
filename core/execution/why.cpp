#include "core/execution/why.h"

#include <algorithm>

namespace race::execution {

using language::Explanation;
using language::Truth;
using semantics::ActionOf;
using semantics::ParameterOf;
using semantics::Program;
using semantics::Subject;
using semantics::WhyAction;
using semantics::WhyParameter;
using semantics::WhyPort;

namespace {

Value truth_json(Truth truth) {
  if (truth == Truth::yes) return true;
  if (truth == Truth::no) return false;
  return nullptr;  // unknown, or it faults
}

bool is_service(const std::string& text) { return text.starts_with("svc"); }

List reads_json(const std::vector<Explanation::Read>& reads) {
  List json;
  for (const Explanation::Read& read : reads) {
    Dict entry{{"text", read.text}};
    if (!read.value.is_unknown()) entry.set("value", read.value);
    json.emplace_back(std::move(entry));
  }
  return json;
}

Value atom_json(const Explanation::Atom& atom, bool decisive, bool together) {
  List requires_;
  for (const Explanation::Read& read : atom.reads)
    if (is_service(read.text)) requires_.emplace_back(read.text);
  Dict json{{"text", atom.text},
            {"value", truth_json(atom.value)},
            {"service", is_service(atom.text) || !requires_.empty()},
            {"blocks", decisive && !together}};
  if (atom.where.line > 0) {
    json.set("line", atom.where.line);
    json.set("column", atom.where.column);
    json.set("end_line", atom.where.end_line);
    json.set("end_column", atom.where.end_column);
  }
  json.set("requires", std::move(requires_));
  json.set("reads", reads_json(atom.reads));
  if (decisive) json.set("wanted", atom.wanted);
  if (decisive && together) json.set("together", true);
  return json;
}

List atoms_json(const Explanation& explanation) {
  List atoms;
  for (std::size_t i = 0; i < explanation.atoms.size(); ++i)
    atoms.push_back(atom_json(explanation.atoms[i],
                              std::ranges::find(explanation.decisive, i) != explanation.decisive.end(),
                              explanation.together));
  return atoms;
}

/// "`a`, `b` or `c`".
std::string listed(const std::vector<std::string>& codes, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < codes.size(); ++i)
    text += (i == 0 ? "`" : i + 1 < codes.size() ? ", `" : std::string(" ") + last + " `") + codes[i] + "`";
  return text;
}

/// When the condition becomes true, as far as its atoms say: "`a` becomes true and `b` becomes false". Empty if never.
std::string decisive_text(const Explanation& explanation) {
  std::string text;
  for (const std::size_t i : explanation.decisive)
    text += (text.empty() ? "`" : (explanation.together ? " and `" : " or `")) + explanation.atoms[i].text +
            "` becomes " + (explanation.atoms[i].wanted ? "true" : "false");
  return text;
}

std::string condition_reason(const Explanation& explanation, const char* verb) {
  if (explanation.value == Truth::fault) return "Its condition cannot be evaluated.";
  const std::string decisive = decisive_text(explanation);
  if (decisive.empty()) return "Its condition cannot become true by changing its atoms.";
  return std::string("It ") + verb + " when " + decisive + ".";
}

std::string reason(const WhyPort& why) {
  if (why.active) return "It has fired and waits to be followed.";
  if (why.forced) return "Somebody has forced it: it fires in the next micro step, whatever its condition is (R24).";
  if (!why.state_active) return "Its state is not active, so it cannot fire.";
  if (why.held_back) return "Its condition is true, but it has fired already in this macro step (R9).";
  if (why.explanation.value == Truth::yes) return "Its condition is true: it fires in the next micro step.";
  return condition_reason(why.explanation, "fires");
}

std::string reason(const WhyAction& why) {
  if (!why.state_active) return "Its state is not active, so it is not executed.";
  if (why.executed) return "It has been executed in this macro step, and is not executed twice in one (3.17).";
  if (why.served) {
    std::string text = "It has been executed for what it has got, and is executed again ";
    if (!why.awaited.empty()) text += "when " + listed(why.awaited, "or") + " is delivered anew";
    if (why.level)
      text += std::string(why.awaited.empty() ? "" : ", or ") + "when its condition has not been fulfilled in between";
    return text + " (R19).";
  }
  if (why.explanation.value != Truth::yes) return condition_reason(why.explanation, "is executed");
  if (!why.unmet) return "Its condition is true: it is executed in the next micro step.";
  if (why.unmet->kind == language::FaultKind::unmet)
    return "Its condition is true, but nothing of its function takes effect: " + why.unmet->message + " (R3).";
  return "Its condition is true, and its function ends in a fault: " + why.unmet->message + ".";
}

std::string reason(const WhyParameter& why, bool turn) {
  if (why.argument) return "An argument of the run gives it.";
  if (why.constant) return "The model gives it, as a constant.";
  if (why.expression.fault)
    return "As things are, its expression cannot be evaluated: " + why.expression.fault->message + ".";
  if (why.expression.value.is_unknown())
    return "As things are, its expression has no value: to activate its state would be a fault (R4).";
  if (turn) return "Its expression was resolved in this micro step, as its state is activated.";
  if (why.state_active)
    return "Its expression was resolved when its state was activated, and is resolved again at the next activation "
           "(R10).";
  return "Its expression is resolved when its state is activated.";
}

Dict to_json(const Program& program, const WhyPort& why) {
  Dict json{{"port", program.address(why.port)},          {"condition", program[why.port].when.text()},
            {"value", truth_json(why.explanation.value)}, {"active", why.active},
            {"state_active", why.state_active},           {"reason", reason(why)},
            {"atoms", atoms_json(why.explanation)}};
  if (why.held_back) json.set("held", "R9");
  if (why.occurrence_hidden) json.set("held", "R21");
  if (why.forced) json.set("forced", true);
  return json;
}

Dict to_json(const Program& program, const WhyAction& why) {
  const semantics::StateInfo& state = program[why.action.state];
  Dict json{{"state", state.path},
            {"action", static_cast<std::int64_t>(why.action.number)},
            {"condition", program.actions[state.actions.low + why.action.number].when.text()},
            {"value", truth_json(why.explanation.value)},
            {"executed", why.executed},
            {"state_active", why.state_active},
            {"reason", reason(why)},
            {"atoms", atoms_json(why.explanation)}};
  if (why.served) json.set("held", "R19");
  if (why.unmet) json.set("held", why.unmet->kind == language::FaultKind::unmet ? "R3" : "R4");
  return json;
}

Dict to_json(const Program& program, const WhyParameter& why, bool turn) {
  const semantics::StateInfo& state = program[why.parameter.state];
  const semantics::ParameterInfo& info = state.parameters[why.parameter.number];
  Dict json{{"state", state.path},
            {"parameter", info.name},
            {"state_active", why.state_active},
            {"reason", reason(why, turn)},
            {"reads", reads_json(why.expression.reads)}};
  if (info.from) json.set("expression", info.from.text());
  if (!why.value.is_unknown()) json.set("value", why.value);
  const Value& given = why.argument ? *why.argument : why.constant ? *why.constant : why.expression.value;
  if (!given.is_unknown()) json.set("gives", given);
  if (why.argument) json.set("argument", true);
  return json;
}

tl::unexpected<Error> not_found(std::string message, const char* field) {
  return unexpected(ErrorCode::not_found, std::move(message), field);
}

}  // namespace

Expected<Subject> find_subject(const Program& program, const WhyQuestion& question) {
  if (!question.port.empty()) {
    const auto port = program.find_port(question.port);
    if (!port) return not_found("there is no port of this path", "port");
    return *port;
  }
  const auto state = program.find_state(question.state);
  if (!state) return not_found("there is no state of this path", "state");
  const semantics::StateInfo& info = program[*state];
  if (question.action) {
    if (*question.action < info.actions.size()) return ActionOf{*state, *question.action};
    return not_found("the state has " + std::to_string(info.actions.size()) + " actions, counted from 0", "action");
  }
  const auto parameter = std::ranges::find(info.parameters, question.parameter, &semantics::ParameterInfo::name);
  if (parameter == info.parameters.end()) return not_found("the state has no parameter of this name", "parameter");
  return ParameterOf{*state, static_cast<std::uint32_t>(parameter - info.parameters.begin())};
}

Execution::Explained Execution::why(const Subject& subject) {
  if (open_)
    if (auto at_turn = run_.why_at_turn(subject)) return {std::move(*at_turn), true};
  return {run_.why(subject)};
}

Value why_json(Execution& execution, const Subject& subject) {
  const Program& program = execution.run().program();
  const auto [why, turn] = execution.why(subject);
  Dict json;
  if (const auto* port = std::get_if<WhyPort>(&why)) json = to_json(program, *port);
  if (const auto* action = std::get_if<WhyAction>(&why)) json = to_json(program, *action);
  if (const auto* parameter = std::get_if<WhyParameter>(&why)) json = to_json(program, *parameter, turn);
  if (turn) json.set("turn", true);
  return json;
}

Expected<Value> why_before(Replay& replay, const WhyQuestion& question, std::uint64_t step, int micro,
                           const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution then, replay.before(step, micro, stop));
  ASSIGN_OR_RETURN(const Subject subject, find_subject(then.run().program(), question));
  return why_json(then, subject);
}

}  // namespace race::execution
