// What code of a state sees while it is evaluated: Δ and Σ of a run, the responses that count in that state (R6, R20),
// and a buffer for what the function writes and calls until it is known whether it completes.
#pragma once

#include <string>
#include <vector>

#include "core/language/interface/environment.h"
#include "core/semantics/budgets.h"
#include "core/semantics/context.h"
#include "core/semantics/evaluation_record.h"

namespace race::semantics {

/// A call of a function that is being evaluated.
struct BufferedCall {
  OperationId operation = kNone;
  std::string service, name;
  List args;
  Dict kwargs;
};

class StepEnvironment final : public language::Environment {
 public:
  /// `the_budgets` outlive this.
  StepEnvironment(const Program& program, RunState& run, ValueLog& log, const Budgets& the_budgets)
      : budgets(the_budgets), program_(program), run_(run), log_(log) {
    attach();
  }

  /// Must be called when the arrays of the run may have moved.
  void attach() {
    values = run_.values.data();
    flags = run_.flags.data();
    event_data = run_.event_data.data();
    sampled = program_.sampled.data();
  }
  /// Whose code runs next, and whether it sees the occurrence of this macro step (R21).
  void enter(StateId state, bool sees_occurrence) {
    state_ = state;
    occurrence = sees_occurrence ? run_.occurrence : kNone;
  }

  const Value& response(OperationId operation, std::string_view service, bool error) override;
  void write(ValueIndex at, Value value) override;
  void call(OperationId operation, std::string_view service, std::string_view name, List args, Dict kwargs) override;
  const language::ServiceTable& services() const override { return program_.services; }
  void print(std::string text) override {
    use.output_units += text.size() + 1;
    printed.push_back(std::move(text));
  }

  /// Adds what a function that completed has done to `use`: its `work` and its calls. False: a budget is exceeded.
  [[gnu::always_inline]] bool take_use(std::uint64_t work) {
    use.work += work;
    if (!calls.empty()) [[unlikely]]
      count_calls();
    return use.work <= budgets.work && use.calls <= budgets.calls && use.output_units <= budgets.output_units;
  }
  /// What says which. Requires that one is.
  std::string exceeded_budget() const;
  /// OPTIMIZATION: most functions call nothing.
  void clear_calls() {
    if (!calls.empty()) [[unlikely]]
      calls.clear();
  }

  const Budgets& budgets;
  MacroStepUse use;                  // of this macro step
  std::vector<BufferedCall> calls;   // of the function that is being evaluated
  std::vector<std::string> printed;  // by functions of this macro step, for people
  EvaluationRecord evaluation;       // of the last evaluation; without a trace, of its calls alone

 private:
  void count_calls();

  const Program& program_;
  RunState& run_;
  ValueLog& log_;
  StateId state_ = kNoState;
};

}  // namespace race::semantics
