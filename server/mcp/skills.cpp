#include "server/mcp/skills.h"

#include <initializer_list>
#include <utility>

namespace race::server::mcp {
namespace {

using Names = std::initializer_list<std::pair<std::string_view, std::string_view>>;  // in the element, in the answer

const List kNothing;

const List& list_of(const Value& element, std::string_view key) {
  const Value* list = element.find(key);
  return list && list->is_list() ? list->as_list() : kNothing;
}

bool is_true(const Value* meta, std::string_view key) {
  const Value* mark = meta ? meta->find(key) : nullptr;
  return mark && mark->is_bool() && mark->as_bool();
}

void copy(Dict& to, const Value* from, const Names& names) {
  for (const auto& [key, name] : names)
    if (const Value* value = from ? from->find(key) : nullptr) to.set(name, *value);
}

Dict described(const Value& element, const Names& fields, const Names& marks) {
  Dict json;
  copy(json, &element, fields);
  copy(json, element.find("meta"), marks);
  return json;
}

List parameters_of(const Value& state) {
  List parameters;
  for (const Value& each : list_of(state, "parameters")) {
    if (is_true(each.find("meta"), "internal")) continue;
    parameters.emplace_back(described(
        each, {{"name", "name"}, {"type", "type"}, {"unit", "unit"}, {"value", "value"}, {"doc", "description"}},
        {{"title", "title"},
         {"domain", "domain"},
         {"min", "min"},
         {"max", "max"},
         {"step", "step"},
         {"choices", "choices"},
         {"advanced", "advanced"},
         {"teaches", "teaches"}}));
  }
  return parameters;
}

Value skill_json(const std::string& document, const Value& state) {
  Dict json{{"document", document}};
  for (const auto& [key, value] :
       described(state, {{"state", "skill"}, {"doc", "description"}}, {{"title", "title"}, {"category", "category"}}))
    json.set(key, value);
  List results, ports;
  for (const Value& each : list_of(state, "results"))
    results.emplace_back(described(each, {{"name", "name"}, {"type", "type"}, {"unit", "unit"}, {"doc", "description"}},
                                   {{"title", "title"}, {"domain", "domain"}}));
  for (const Value& each : list_of(state, "ports"))
    ports.emplace_back(
        described(each, {{"name", "name"}}, {{"title", "title"}, {"advice", "advice"}, {"nominal", "nominal"}}));
  json.set("parameters", parameters_of(state));
  json.set("results", std::move(results));
  json.set("ports", std::move(ports));
  return json;
}

}  // namespace

List skills_of(const std::string& name, const Value& document) {
  List skills;
  for (const Value& state : list_of(document, "library"))
    if (is_true(state.find("meta"), "skill")) skills.push_back(skill_json(name, state));
  return skills;
}

}  // namespace race::server::mcp
