#include "core/language/interface/service_table.h"

#include <algorithm>

namespace race::language {

EventId ServiceTable::declare_event(std::string_view service, std::string_view name, bool sampled) {
  const EventId id = event(service, name);
  events_[id].sampled = sampled;
  events_[id].declared = true;
  return id;
}

OperationId ServiceTable::declare_operation(std::string_view service, std::string_view name, bool safe) {
  const OperationId id = operation(service, name);
  operations_[id].safe = safe;
  operations_[id].declared = true;
  return id;
}

EventId ServiceTable::event(std::string_view service, std::string_view name) {
  const auto [at, is_new] = event_ids_.try_emplace(Key(service, name), static_cast<EventId>(events_.size()));
  if (is_new) events_.push_back({std::string(service), std::string(name)});
  return at->second;
}

OperationId ServiceTable::operation(std::string_view service, std::string_view name) {
  const auto [at, is_new] =
      operation_ids_.try_emplace(Key(service, name), static_cast<OperationId>(operations_.size()));
  if (is_new) operations_.push_back({std::string(service), std::string(name)});
  return at->second;
}

OperationId ServiceTable::open_operation(std::string_view name) {
  const auto [at, is_new] = open_ids_.try_emplace(std::string(name), static_cast<OperationId>(operations_.size()));
  if (is_new) operations_.push_back({.service = {}, .name = std::string(name), .open = true});
  return at->second;
}

EventId ServiceTable::find_event(std::string_view service, std::string_view name) const {
  const auto found = event_ids_.find(Key(service, name));
  return found == event_ids_.end() ? kNone : found->second;
}

OperationId ServiceTable::find_operation(std::string_view service, std::string_view name) const {
  const auto found = operation_ids_.find(Key(service, name));
  return found == operation_ids_.end() ? kNone : found->second;
}

OperationId ServiceTable::dynamic_operation(std::string_view service, std::string_view name) const {
  const OperationId found = find_operation(service, name);
  if (found != kNone) return found;
  const auto open = open_ids_.find(name);
  return open == open_ids_.end() ? kNone : open->second;
}

std::vector<std::string> ServiceTable::declared_services() const {
  std::vector<std::string> names;
  const auto add = [&](const auto& entry) {
    if (entry.declared && std::find(names.begin(), names.end(), entry.service) == names.end())
      names.push_back(entry.service);
  };
  for (const Event& event : events_) add(event);
  for (const Operation& operation : operations_) add(operation);
  return names;
}

}  // namespace race::language
