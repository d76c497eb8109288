// Writing documents: fields in the order of the format, what is empty left out.
#include "core/rcm/document.h"

namespace race::rcm {
namespace {

void set_text(Dict& out, std::string_view key, const std::string& text) {
  if (!text.empty()) out.set(key, text);
}

void set_text(Dict& out, std::string_view key, const std::optional<std::string>& text) {
  if (text) out.set(key, *text);
}

void set_json(Dict& out, std::string_view key, const Value& json) {
  if (!json.is_null()) out.set(key, json);
}

void set_meta(Dict& out, const Meta& meta) {
  if (meta.id.empty()) return set_json(out, "meta", meta.rest);
  Dict entries{{"id", meta.id}};
  if (meta.rest.is_dict()) {
    for (const auto& [key, value] : meta.rest.as_dict()) entries.set(key, value);
  }
  out.set("meta", std::move(entries));
}

Value texts(const std::vector<std::string>& items) { return List(items.begin(), items.end()); }

template <typename T, typename Write>
void set_list(Dict& out, std::string_view key, const std::vector<T>& items, Write write) {
  if (items.empty()) return;
  List list;
  for (const T& item : items) list.push_back(write(item));
  out.set(key, std::move(list));
}

Value write_parameter(const Parameter& parameter) {
  Dict out{{"name", parameter.name}};
  if (parameter.value) out.set("value", *parameter.value);
  set_text(out, "from", parameter.from);
  set_json(out, "type", parameter.type);
  set_text(out, "unit", parameter.unit);
  set_text(out, "doc", parameter.doc);
  set_meta(out, parameter.meta);
  return out;
}

Value write_datum(const Datum& datum) {
  Dict out{{"name", datum.name}};
  if (datum.initial) out.set("initial", *datum.initial);
  set_json(out, "type", datum.type);
  set_text(out, "unit", datum.unit);
  set_text(out, "doc", datum.doc);
  set_meta(out, datum.meta);
  return out;
}

Value write_action(const Action& action) {
  Dict out{{"when", action.when}, {"do", action.code}};
  set_meta(out, action.meta);
  return out;
}

Value write_port(const Port& port) {
  Dict out{{"name", port.name}};
  set_text(out, "when", port.when);
  set_text(out, "to", port.to);
  set_meta(out, port.meta);
  return out;
}

Value write_oracle(const Oracle& oracle) {
  switch (oracle.kind) {
    case Oracle::Kind::expr:
      return Dict{{"kind", "expr"}, {"expr", oracle.text}};
    case Oracle::Kind::external:
      return Dict{{"kind", "external"}, {"call", oracle.text}};
    case Oracle::Kind::history:
      break;
  }
  Dict out{{"kind", "history"}};
  if (oracle.resume) out.set("resume", texts(*oracle.resume));
  return out;
}

Value write_node(const Node& node) {
  if (const auto* state = std::get_if<State>(&node)) return write_state(*state);
  const Barrier& barrier = std::get<Barrier>(node);
  Dict out{{"barrier", barrier.name}, {"to", texts(barrier.to)}};
  set_meta(out, barrier.meta);
  return out;
}

}  // namespace

Value write_state(const State& state) {
  Dict out{{"state", state.name}};
  set_text(out, "doc", state.doc);
  set_list(out, "parameters", state.parameters, write_parameter);
  set_list(out, "results", state.results, write_datum);
  set_list(out, "variables", state.variables, write_datum);
  set_text(out, "entry", state.entry);
  set_text(out, "exit", state.exit);
  set_list(out, "actions", state.actions, write_action);
  set_list(out, "children", state.children, write_node);
  set_text(out, "first", state.first);
  set_list(out, "ports", state.ports, write_port);
  if (state.keep) out.set("keep", state.keep->any ? Value(true) : texts(state.keep->ports));
  set_text(out, "link", state.link);
  if (state.oracle) out.set("oracle", write_oracle(*state.oracle));
  set_meta(out, state.meta);
  return out;
}

Value write_document(const Document& document) {
  Dict out{{"rcm", 1}};
  set_text(out, "name", document.name);
  if (!document.services.empty()) {
    Dict services;
    for (const auto& [key, type] : document.services) services.set(std::string_view(key), type);
    out.set("services", std::move(services));
  }
  set_list(out, "library", document.library, write_state);
  out.set("root", write_state(document.root));
  set_json(out, "layout", document.layout);
  set_json(out, "meta", document.meta);
  return out;
}

}  // namespace race::rcm
