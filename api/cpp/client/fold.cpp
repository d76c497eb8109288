#include "api/cpp/client/fold.h"

#include <algorithm>
#include <array>
#include <utility>

namespace race::client {
namespace {

constexpr std::array<std::string_view, 2> kMembers = {"active", "ports"};
constexpr std::array<std::string_view, 3> kValues = {"parameters", "results", "variables"};

const Dict* dict_of(const Value& value, std::string_view field) {
  const Value* const found = value.find(field);
  return found && found->is_dict() ? &found->as_dict() : nullptr;
}

const List* list_of(const Value& value, std::string_view field) {
  const Value* const found = value.find(field);
  return found && found->is_list() ? &found->as_list() : nullptr;
}

// Names that are active now; `changes`: name -> whether it is.
List members(const List& before, const Dict& changes) {
  List after;
  for (const Value& name : before) {
    const Value* const change = name.is_string() ? changes.find(name) : nullptr;
    if (!change || *change == Value(true)) after.push_back(name);
  }
  for (const auto& [name, is_active] : changes)
    if (is_active == Value(true) && std::find(before.begin(), before.end(), name) == before.end())
      after.push_back(name);
  return after;
}

// Barrier -> ports that have arrived, without those to which none have.
Dict arrivals(Dict after, const Dict& changes) {
  for (const auto& [barrier, ports] : changes) {
    if (ports.is_list() && ports.as_list().empty())
      after.erase(barrier.as_string());
    else
      after.set(barrier, ports);
  }
  return after;
}

// Fields of a path; a path without any is not there.
void set_fields(Dict& values, const Value& path, Dict fields) {
  if (fields.empty())
    values.erase(path.as_string());
  else
    values.set(path, std::move(fields));
}

Dict fields_of(const Dict& values, const Value& path) {
  const Value* const found = values.find(path);
  return found && found->is_dict() ? found->as_dict() : Dict();
}

// Path -> name -> value, without those that are set no more (path -> names).
Dict values_after(Dict after, const Dict& changes, const Dict* unset) {
  for (const auto& [path, set] : changes) {
    Dict fields = fields_of(after, path);
    if (set.is_dict())
      for (const auto& [name, value] : set.as_dict()) fields.set(name, value);
    set_fields(after, path, std::move(fields));
  }
  if (!unset) return after;
  for (const auto& [path, names] : *unset) {
    Dict fields = fields_of(after, path);
    if (names.is_list())
      for (const Value& name : names.as_list())
        if (name.is_string()) fields.erase(name.as_string());
    set_fields(after, path, std::move(fields));
  }
  return after;
}

bool is_delta(const Value& delta) {
  const auto has = [&delta](std::string_view field) { return dict_of(delta, field) != nullptr; };
  return !status_of(delta).empty() && std::all_of(kMembers.begin(), kMembers.end(), has) && has("activated") &&
         std::all_of(kValues.begin(), kValues.end(), has) && has("unset");
}

}  // namespace

bool is_over(std::string_view status) { return status == "ended" || status == "faulted" || status == "aborted"; }

std::string_view status_of(const Value& state) {
  const Value* const core = state.find("core");
  const Value* const status = core ? core->find("status") : nullptr;
  return status && status->is_string() ? std::string_view(status->as_string()) : std::string_view();
}

bool is_state(const Value& state) {
  const Value* const inner = state.find("state");
  if (!inner || status_of(state).empty()) return false;
  const auto has_list = [inner](std::string_view field) { return list_of(*inner, field) != nullptr; };
  const auto has_dict = [inner](std::string_view field) { return dict_of(*inner, field) != nullptr; };
  return std::all_of(kMembers.begin(), kMembers.end(), has_list) && has_dict("activated") &&
         std::all_of(kValues.begin(), kValues.end(), has_dict);
}

std::optional<Value> fold(const Value& before, const Value& delta) {
  if (!is_state(before) || !is_delta(delta)) return std::nullopt;
  const Value& state = *before.find("state");
  const Value& unset = *delta.find("unset");
  Dict after;
  for (const std::string_view field : kMembers)
    after.set(field, members(*list_of(state, field), *dict_of(delta, field)));
  after.set("activated", arrivals(*dict_of(state, "activated"), *dict_of(delta, "activated")));
  for (const std::string_view field : kValues)
    after.set(field, values_after(*dict_of(state, field), *dict_of(delta, field), dict_of(unset, field)));
  return Value(Dict{{"core", *delta.find("core")}, {"state", std::move(after)}});
}

}  // namespace race::client
