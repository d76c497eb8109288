// What a Run is made of: for run.cpp, run_inputs.cpp and its checkpoints.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/semantics/environment.h"
#include "core/semantics/run.h"
#include "core/semantics/step_log.h"

namespace race::semantics {

struct Run::Body {
  Body(std::shared_ptr<const Program> p, Budgets b)
      : program(std::move(p)),
        budgets(b),
        state(*program),
        environment(*program, state, work.log.values, budgets),
        interpreter(b.evaluation) {}
  Body(const Body& other)
      : program(other.program),
        budgets(other.budgets),
        state(other.state),
        environment(*program, state, work.log.values, budgets),
        interpreter(other.budgets.evaluation),
        arguments(other.arguments),
        status(other.status),
        outcome(other.outcome),
        fault(other.fault),
        outgoing(other.outgoing),
        micro_steps(other.micro_steps),
        position(other.position) {
    environment.use = other.environment.use;
  }
  Body& operator=(const Body&) = delete;

  void make_safe_calls(std::vector<OutgoingCall> calls) {
    state.call_count += calls.size();
    for (OutgoingCall& call : calls) outgoing.push_back(std::move(call));
  }

  std::shared_ptr<const Program> program;  // held by every run of it
  Budgets budgets;
  RunState state;
  Workspace work;
  StepEnvironment environment;
  language::Interpreter interpreter;
  std::vector<Value> arguments;  // by parameter of the root; unknown: none given
  Status status = Status::running;
  std::string outcome;
  std::optional<RunFault> fault;
  std::vector<OutgoingCall> outgoing;
  std::uint32_t micro_steps = 0;  // of this macro step
  std::uint64_t position = 0;
};

}  // namespace race::semantics
