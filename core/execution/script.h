// Scripts: a run driven without real services (core/SEMANTICS.md section 7). `race derive` is this.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/edit/operation.h"
#include "core/execution/order_choice.h"
#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/semantics/force.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::execution {

struct ScriptEvent {
  std::string service, event;
  Value data;
};

/// `call` 0: the latest call of that operation.
struct ScriptResponse {
  std::string service, operation;
  std::uint64_t call = 0;
  bool is_error = false;
  Value data;
};

/// A spontaneous transition of a service; `call`: which it answers, if it may answer several (R25), else 0.
struct ScriptTransition {
  std::string service, id;
  std::uint64_t call = 0;
};

/// Inputs that join those that wait, then one Exec (4.20), in which services take the transitions named here. With
/// `force`, that is its macro step; an edit is tried now and before each later macro step, until it can be carried
/// over, in a macro step of its own.
struct ScriptStep {
  std::optional<edit::Edit> edit;  // of the document
  std::optional<semantics::Force> force;
  std::vector<ScriptEvent> events;
  std::vector<ScriptResponse> responses;
  std::vector<ScriptTransition> transitions;
};

struct Script {
  Dict arguments;
  std::vector<std::pair<std::string, rsm::Service>> services;  // as declared
  Dict results;                                                // "S1.op" -> result of a service with an RSM
  std::vector<ScriptStep> steps;
  bool closed = false;  // a call to what `services` does not have waits for the script, and is not answered
};

/// Reads script.json. Violations: as the RSM codec for `services/NAME`; `type`, `missing`, `unknown_field` with paths
/// such as `steps/3`.
Checked<Script> read_script(const Value& json);

/// The document that `race derive` prints. Errors: violations of the document and its program; an argument that the
/// root does not have; at `steps/N/edit/...` and `steps/N/force` what does not fit the document and the run.
Checked<Value> derive(const rcm::Document& document, const Script& script, OrderChoice order = {});

}  // namespace race::execution
