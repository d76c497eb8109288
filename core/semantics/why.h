// Why a port fires or not, why an action is executed or not, and what a parameter is resolved to. For people.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/language/evaluate/explain.h"
#include "core/language/interface/fault.h"
#include "core/semantics/program.h"

namespace race::semantics {

/// An action or a parameter of a state, by its number within it.
struct ActionOf {
  StateId state;
  std::uint32_t number;
};
struct ParameterOf {
  StateId state;
  std::uint32_t number;
};
/// What is asked about.
using Subject = std::variant<PortId, ActionOf, ParameterOf>;

struct WhyPort {
  PortId port;
  language::Explanation explanation = {};  // of its condition
  bool state_active = false;
  bool active = false;
  bool held_back = false;          // R9: fulfilled, but it has fired in this macro step
  bool occurrence_hidden = false;  // R21
  bool forced = false;             // R24: its condition is not evaluated
};

struct WhyAction {
  ActionOf action;
  language::Explanation explanation = {};  // of its condition
  bool state_active = false;
  bool executed = false;  // Action2 (3.17): in this macro step
  bool served = false;    // R19: it is not executed again before one of `awaited` is delivered, or, if `level`, its
  bool level = false;     // condition has not been fulfilled
  std::vector<std::string> awaited = {};      // as code names them
  std::optional<language::Fault> unmet = {};  // R3: its condition is fulfilled, its function is not; or ends in a fault
};

struct WhyParameter {
  ParameterOf parameter;
  bool state_active = false;
  Value value = Value::unknown();      // that it has; unknown if none
  std::optional<Value> argument = {};  // R13
  std::optional<Value> constant = {};  // of the model
  language::ExplainedValue expression =
      {};  // in the scope of the parent; nothing where one of the others stands for it
};

using Why = std::variant<WhyPort, WhyAction, WhyParameter>;

}  // namespace race::semantics
