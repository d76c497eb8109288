// The service table: events and operations of services by number.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/language/interface/ids.h"

namespace race::language {

/// Every service event and operation that a program can name, by number. Built from the services that are known (their
/// declarations), extended by `event()` and `operation()` with names that no declaration has.
///
/// `svc[expr].op` may name an operation that the table does not have. For these there is one entry per name, the *open*
/// operation `op`: it represents all services without an entry of that name.
class ServiceTable {
 public:
  struct Event {
    std::string service, name;
    bool sampled = false;
    bool declared = false;  // by its service; else only named by code
  };
  struct Operation {
    std::string service, name;  // no service: an open one
    bool safe = false;
    bool declared = false;
    bool open = false;
  };
  /// Adds a declared event or operation; returns its number (the existing one, updated, if there is one).
  EventId declare_event(std::string_view service, std::string_view name, bool sampled);
  OperationId declare_operation(std::string_view service, std::string_view name, bool safe);
  /// The number of a name, added undeclared (not sampled, not safe) if it is new.
  EventId event(std::string_view service, std::string_view name);
  OperationId operation(std::string_view service, std::string_view name);
  /// kNone if the table does not have it.
  EventId find_event(std::string_view service, std::string_view name) const;
  OperationId find_operation(std::string_view service, std::string_view name) const;
  /// The number of the open operation of this name, added if it is new.
  OperationId open_operation(std::string_view name);
  bool is_open(OperationId operation) const { return operations_[operation].open; }
  /// What svc[service].name is: the entry if there is one, else the open operation. kNone if there is neither.
  OperationId dynamic_operation(std::string_view service, std::string_view name) const;
  const std::vector<Event>& events() const { return events_; }
  const std::vector<Operation>& operations() const { return operations_; }
  /// Services that have declared an event or operation, in order of appearance.
  std::vector<std::string> declared_services() const;

 private:
  using Key = std::pair<std::string, std::string>;
  std::vector<Event> events_;
  std::vector<Operation> operations_;
  std::map<Key, std::uint32_t> event_ids_, operation_ids_;
  std::map<std::string, OperationId, std::less<>> open_ids_;
};

}  // namespace race::language
