// The fields of each element of the format, in order; what is empty is left out, entries are in order (entries.h).
// for_each_field calls visit(key, field), where a field is a text, texts, JSON, a `meta`, an oracle, a state or a list
// of elements. Used by write.cpp (JSON as a value) and format.cpp (JSON as text).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/entries.h"
#include "core/rcm/model.h"

namespace race::rcm {

/// Calls visit(key, field) unless `field` is empty.
template <typename Visit>
void visit_text(std::string_view key, const std::string& text, Visit& visit) {
  if (!text.empty()) visit(key, text);
}

template <typename Visit>
void visit_text(std::string_view key, const std::optional<std::string>& text, Visit& visit) {
  if (text) visit(key, *text);
}

template <typename Visit>
void visit_json(std::string_view key, const Value& json, Visit& visit) {
  if (!json.is_null()) visit(key, json);
}

template <typename Element, typename Visit>
void visit_list(std::string_view key, const std::vector<Element>& elements, Visit& visit) {
  if (!elements.empty()) visit(key, elements);
}

template <typename Visit>
void visit_meta(const Meta& meta, Visit& visit) {
  if (!meta.id.empty() || !ordered_entries(meta.rest).is_null()) visit("meta", meta);
}

template <typename Visit>
void for_each_field(const Parameter& parameter, Visit& visit) {
  visit("name", parameter.name);
  if (parameter.value) visit("value", *parameter.value);
  visit_text("from", parameter.from, visit);
  visit_json("type", parameter.type, visit);
  visit_text("unit", parameter.unit, visit);
  visit_text("doc", parameter.doc, visit);
  visit_meta(parameter.meta, visit);
}

template <typename Visit>
void for_each_field(const Datum& datum, Visit& visit) {
  visit("name", datum.name);
  if (datum.initial) visit("initial", *datum.initial);
  visit_json("type", datum.type, visit);
  visit_text("unit", datum.unit, visit);
  visit_text("doc", datum.doc, visit);
  visit_meta(datum.meta, visit);
}

template <typename Visit>
void for_each_field(const Action& action, Visit& visit) {
  visit("when", action.when);
  visit("do", action.code);
  visit_meta(action.meta, visit);
}

template <typename Visit>
void for_each_field(const Port& port, Visit& visit) {
  visit("name", port.name);
  visit_text("when", port.when, visit);
  visit_text("after", port.after, visit);
  visit_text("to", port.to, visit);
  visit_meta(port.meta, visit);
}

template <typename Visit>
void for_each_field(const Barrier& barrier, Visit& visit) {
  visit("barrier", barrier.name);
  visit("to", barrier.to);
  visit_meta(barrier.meta, visit);
}

template <typename Visit>
void for_each_field(const Oracle& oracle, Visit& visit) {
  static const std::string kKinds[] = {"expr", "external", "history"};
  visit("kind", kKinds[static_cast<std::size_t>(oracle.kind)]);
  if (oracle.kind == Oracle::Kind::expr) visit("expr", oracle.text);
  if (oracle.kind == Oracle::Kind::external) visit("call", oracle.text);
  if (oracle.kind == Oracle::Kind::history && oracle.resume) visit("resume", *oracle.resume);
  if (oracle.deep) visit("deep", Value(true));
}

inline Value keep_json(const Keep& keep) {
  if (!keep.deep && keep.any) return true;
  List ports;
  for (const std::string& port : keep.ports) ports.push_back(port);
  if (!keep.deep) return ports;
  Dict out{{"deep", true}};
  if (!keep.any) out.set("ports", std::move(ports));
  return out;
}

template <typename Visit>
void for_each_field(const State& state, Visit& visit) {
  visit("state", state.name);
  visit_text("doc", state.doc, visit);
  visit_list("parameters", state.parameters, visit);
  visit_list("results", state.results, visit);
  visit_list("variables", state.variables, visit);
  visit_text("entry", state.entry, visit);
  visit_text("exit", state.exit, visit);
  visit_list("actions", state.actions, visit);
  visit_list("children", state.children, visit);
  visit_text("first", state.first, visit);
  visit_list("ports", state.ports, visit);
  if (state.keep) visit("keep", keep_json(*state.keep));
  visit_text("link", state.link, visit);
  if (state.oracle) visit("oracle", *state.oracle);
  visit_meta(state.meta, visit);
}

template <typename Visit>
void for_each_field(const Document& document, Visit& visit) {
  visit("rcm", Value(1));
  visit_text("name", document.name, visit);
  if (!document.services.empty()) visit("services", document.services);
  visit_list("library", document.library, visit);
  visit("root", document.root);
  visit_json("layout", ordered_entries(document.layout), visit);
  visit_json("meta", ordered_document_meta(document.meta), visit);
}

}  // namespace race::rcm
