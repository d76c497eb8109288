// The syntax of RSM (thesis 4.2, Definitions 4.1 to 4.3): what a service offers and in which of its states.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/value/value.h"

namespace race::rsm {

struct OperationParameter {
  std::string name;
  Value type;  // TYPE as JSON, or null
  std::string unit, doc;
  std::optional<double> min, max;
  std::optional<Value> value;  // default
  bool operator==(const OperationParameter&) const = default;
};

struct Operation {
  std::string name;
  std::vector<OperationParameter> parameters;
  Value result, error;  // TYPE as JSON, or null; a declared `error` means: may answer with one
  bool safe = false;    // invoked when a run faults or is aborted
  std::string doc;
  bool moves = false;  // may set something in the cell in motion; for people, who are asked before a run begins
  bool held = false;   // called again and again while a person holds a button; for who calls by hand
  bool paces = false;  // of one that `moves`: changes only how fast what is in motion already goes on
  bool reads = false;  // changes nothing; for who calls by hand while somebody else has the controls
  bool operator==(const Operation&) const = default;
};

struct Event {
  std::string name;
  Value data;            // TYPE as JSON, or null
  bool sampled = false;  // only the newest waiting occurrence counts (R5)
  std::optional<double> rate_hz;
  std::string doc;
  bool operator==(const Event&) const = default;
};

struct ServiceState {
  std::string name;
  std::vector<std::string> events;  // put while the service stutters
  bool operator==(const ServiceState&) const = default;
};

struct Transition {
  std::string id;
  std::optional<std::string> src;  // none: from every state
  std::string dst;
  std::optional<std::string> operation;  // none: spontaneous
  std::vector<std::string> events;
  std::vector<std::string> defer;    // the transitions that answer this one's call
  std::optional<std::string> error;  // deferred calls that this resolves are answered with this code
  bool concurrent = false;           // each call that takes this one is answered by itself (R25)
  bool operator==(const Transition&) const = default;
};

struct Uses {
  std::string service, name;
  bool operator==(const Uses&) const = default;
};

struct Service {
  std::string name;
  std::vector<Operation> operations;
  std::vector<Event> events;
  std::vector<Uses> subscribes, calls;  // data-flow between services (4.1)
  std::vector<ServiceState> states;     // none in an interface (operations and events only)
  std::string init;
  std::vector<Transition> transitions;
  Value meta;
  bool operator==(const Service&) const = default;

  bool is_interface() const { return states.empty(); }
};

}  // namespace race::rsm
