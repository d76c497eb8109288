#include "core/rcm/oracle.h"

#include "core/rcm/call_text.h"

namespace race::rcm {
namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

std::vector<std::string> child_states(const State& composite) {
  std::vector<std::string> out;
  for (const Node& child : composite.children) {
    if (const auto* state = std::get_if<State>(&child)) out.push_back(state->name);
  }
  return out;
}

Parameter parameter_from(std::string name, std::string expression) {
  Parameter out;
  out.name = std::move(name);
  out.from = std::move(expression);
  return out;
}

Port port(std::string name, std::string when, std::string to) {
  return Port{std::move(name), std::move(when), std::move(to), Value()};
}

/// The choice is known and names no child.
std::string names_none(const std::string& choice, const std::vector<std::string>& children) {
  std::string list;
  for (const std::string& child : children) list += (list.empty() ? "" : ", ") + quoted(child);
  return "available(" + choice + ") and " + choice + " not in [" + list + "]";
}

/// The call with `par.arg0`, `par.arg1`, ... for its arguments, which become parameters of the dispatcher.
std::string pass_arguments(const CallText& call, std::vector<Parameter>& parameters) {
  std::string out;
  for (const auto& [keyword, expression] : call.arguments) {
    const std::string name = "arg" + std::to_string(parameters.size());
    parameters.push_back(parameter_from(name, expression));
    out += (out.empty() ? "" : ", ") + (keyword.empty() ? "" : keyword + "=") + "par." + name;
  }
  return "svc." + call.service + "." + call.operation + "(" + out + ")";
}

/// The dispatcher of an external oracle calls on entry and stores the result.
void ask(const CallText& call, State& dispatcher) {
  const std::string operation = "svc." + call.service + "." + call.operation;
  dispatcher.entry = pass_arguments(call, dispatcher.parameters);
  dispatcher.results.push_back(Datum{"choice", std::nullopt, Value(), "", "", Value()});
  dispatcher.actions.push_back(Action{operation + ".result", "res.choice = " + operation + ".result", Value()});
}

void remember_child(State& composite) {
  Datum last{std::string(kLastActive), Value(composite.first.value_or("")), Value(), "", "", Value()};
  composite.variables.push_back(std::move(last));
  for (const std::string& child : child_states(composite))
    composite.actions.push_back(Action{"chi." + child + ".active and var.last_active != " + quoted(child),
                                       "var.last_active = " + quoted(child), Value()});
  const auto& resume = composite.oracle->resume;
  composite.keep = resume ? Keep{.any = false, .ports = *resume} : Keep{.any = true, .ports = {}};
}

}  // namespace

State dispatcher(const State& composite) {
  const Oracle& oracle = *composite.oracle;
  const std::vector<std::string> children = child_states(composite);
  State out;
  out.name = kDispatcher;
  std::string choice = "par.choice", otherwise;
  if (oracle.kind == Oracle::Kind::external) {
    choice = "res.choice";
    if (const auto call = parse_call(oracle.text)) {
      ask(*call, out);
      otherwise = "svc." + call->service + "." + call->operation + ".error or ";
    }
  } else {
    const bool history = oracle.kind == Oracle::Kind::history;
    out.parameters.push_back(parameter_from("choice", history ? "var.last_active" : oracle.text));
  }
  for (const std::string& child : children)
    out.ports.push_back(port("to_" + child, choice + " == " + quoted(child), child));
  const std::string none = names_none(choice, children);
  if (composite.first)
    out.ports.push_back(port("otherwise", otherwise.empty() ? none : otherwise + "(" + none + ")", *composite.first));
  return out;
}

void translate_oracle(State& composite) {
  State first = dispatcher(composite);
  if (composite.oracle->kind == Oracle::Kind::history) remember_child(composite);
  composite.first = first.name;
  composite.children.insert(composite.children.begin(), std::move(first));
  composite.oracle.reset();
}

}  // namespace race::rcm
