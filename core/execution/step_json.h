// Steps as JSON: a macro step with its derivation, its calls, and how a run ended.
#pragma once

#include <vector>

#include "core/execution/execution.h"

namespace race::execution {

/// schemas/call.json
Value call_json(const semantics::OutgoingCall& call);
List calls_json(const std::vector<semantics::OutgoingCall>& calls);

/// The trees of all micro steps of `derivation`.
List micro_steps_json(const semantics::Program& program, const semantics::Derivation& derivation);

/// A step whose derivation was recorded, as schemas/trace_step.json without `state`.
Dict trace_step(const semantics::Program& program, const Progress& progress);

/// The step that `execution` has just done with its derivation, as a derivation document has it (core/SEMANTICS.md
/// section 7): calls without their numbers, and the state after it.
Value derived_step(const Execution& execution, const Progress& progress);

/// What holds an edit up: {"path", "id"?, "parameter"?} of each.
List obstacles_json(const std::vector<semantics::Obstacle>& obstacles);

/// The results of the root that are set.
Value root_results(const semantics::Run& run);

/// {"kind", "at", "message"}
Value fault_json(const semantics::RunFault& fault);

/// Sets `status`, and `outcome` or `fault`.
void set_status(const semantics::Run& run, Dict& json);

}  // namespace race::execution
