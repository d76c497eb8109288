#include "core/rcm/oracle.h"

#include "core/rcm/call_text.h"

namespace race::rcm {
namespace {

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

std::vector<const State*> child_states(const State& composite) {
  std::vector<const State*> out;
  for (const Node& child : composite.children) {
    if (const auto* state = std::get_if<State>(&child)) out.push_back(state);
  }
  return out;
}

/// What an oracle is translated to has ids of its owner and its role in it. A role is no id: it begins with a colon.
Meta derived_meta(const State& owner, std::string_view role, DerivedIds& ids) {
  return Meta{ids(owner.meta.id, role), Value()};
}

Parameter parameter_from(std::string name, std::string expression, Meta meta) {
  Parameter out;
  out.meta = std::move(meta);
  out.name = std::move(name);
  out.from = std::move(expression);
  return out;
}

Port port(std::string name, std::string when, std::string to, Meta meta) {
  return Port{std::move(name), std::move(when), std::nullopt, std::move(to), std::move(meta)};
}

/// The choice is known and names no child.
std::string names_none(const std::string& choice, const std::vector<const State*>& children) {
  std::string list;
  for (const State* child : children) list += (list.empty() ? "" : ", ") + quoted(child->name);
  return "available(" + choice + ") and " + choice + " not in [" + list + "]";
}

/// The call with `par.arg0`, `par.arg1`, ... for its arguments, which become parameters of the dispatcher.
std::string pass_arguments(const CallText& call, State& dispatcher, DerivedIds& ids) {
  std::string out;
  for (const auto& [keyword, expression] : call.arguments) {
    const std::string name = "arg" + std::to_string(dispatcher.parameters.size());
    dispatcher.parameters.push_back(parameter_from(name, expression, derived_meta(dispatcher, ":" + name, ids)));
    out += (out.empty() ? "" : ", ") + (keyword.empty() ? "" : keyword + "=") + "par." + name;
  }
  return "svc." + call.service + "." + call.operation + "(" + out + ")";
}

/// The dispatcher of an external oracle calls on entry and stores the result.
void ask(const CallText& call, State& dispatcher, DerivedIds& ids) {
  const std::string operation = "svc." + call.service + "." + call.operation;
  dispatcher.entry = pass_arguments(call, dispatcher, ids);
  dispatcher.results.push_back(
      Datum{"choice", std::nullopt, Value(), "", "", derived_meta(dispatcher, ":result", ids)});
  dispatcher.actions.push_back(
      Action{operation + ".result", "res.choice = " + operation + ".result", derived_meta(dispatcher, ":store", ids)});
}

void remember_child(State& composite, DerivedIds& ids) {
  const Meta last = derived_meta(composite, ":last_active", ids);
  composite.variables.push_back(
      Datum{std::string(kLastActive), Value(composite.first.value_or("")), Value(), "", "", last});
  for (const State* child : child_states(composite))
    composite.actions.push_back(Action{"chi." + child->name + ".active and var.last_active != " + quoted(child->name),
                                       "var.last_active = " + quoted(child->name),
                                       Meta{ids(last.id, child->meta.id), Value()}});
  const auto& resume = composite.oracle->resume;
  composite.keep =
      Keep{.any = !resume, .ports = resume.value_or(std::vector<std::string>()), .deep = composite.oracle->deep};
}

}  // namespace

State dispatcher(const State& composite, DerivedIds& ids) {
  const Oracle& oracle = *composite.oracle;
  const std::vector<const State*> children = child_states(composite);
  State out;
  out.name = kDispatcher;
  out.meta = derived_meta(composite, ":dispatcher", ids);
  std::string choice = "par.choice", otherwise;
  if (oracle.kind == Oracle::Kind::external) {
    choice = "res.choice";
    if (const auto call = parse_call(oracle.text)) {
      ask(*call, out, ids);
      otherwise = "svc." + call->service + "." + call->operation + ".error or ";
    }
  } else {
    const bool history = oracle.kind == Oracle::Kind::history;
    out.parameters.push_back(
        parameter_from("choice", history ? "var.last_active" : oracle.text, derived_meta(out, ":choice", ids)));
  }
  for (const State* child : children)
    out.ports.push_back(port("to_" + child->name, choice + " == " + quoted(child->name), child->name,
                             derived_meta(out, child->meta.id, ids)));
  const std::string none = names_none(choice, children);
  if (composite.first)
    out.ports.push_back(port("otherwise", otherwise.empty() ? none : otherwise + "(" + none + ")", *composite.first,
                             derived_meta(out, ":otherwise", ids)));
  return out;
}

void translate_oracle(State& composite, DerivedIds& ids) {
  State first = dispatcher(composite, ids);
  if (composite.oracle->kind == Oracle::Kind::history) remember_child(composite, ids);
  composite.first = first.name;
  composite.children.insert(composite.children.begin(), std::move(first));
  composite.oracle.reset();
}

}  // namespace race::rcm
