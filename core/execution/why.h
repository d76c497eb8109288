// Why a port fires or does not fire, why an action is executed or not, and what a parameter is resolved to, as
// schemas/why.json.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/execution/replay.h"

namespace race::execution {

/// What is asked about, as people and clients name it: a port by its address; else an action or a parameter of a state.
struct WhyQuestion {
  std::string port;  // Root/Pick/Grasp.success
  std::string state;
  std::optional<std::uint32_t> action;  // from 0, within the state
  std::string parameter;                // its name
};

/// Error: `not_found`, at the field of the question.
Expected<semantics::Subject> find_subject(const semantics::Program& program, const WhyQuestion& question);

/// Of an execution as it stands (Execution::why).
Value why_json(Execution& execution, const semantics::Subject& subject);

/// As things were before micro step `micro`, from 0, of macro step `step`, and when its turn came in it. Requires as
/// Replay::before. Errors: those of it, and of find_subject in the model of then.
Expected<Value> why_before(Replay& replay, const WhyQuestion& question, std::uint64_t step, int micro,
                           const std::atomic<bool>* stop = nullptr);

}  // namespace race::execution
