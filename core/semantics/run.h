// Run: the contexts Σ and Δ of a Program that is executed, from the activation of its root to its outcome, and the
// steps of both. Each input is one macro step (R5); a macro step is micro steps until quiescence (3.32). Who waits and
// who is told is not its business: core/execution drives it.
//
// A Run is a function of (program, arguments, inputs in order of delivery). It is a value: a copy goes on from the same
// point. It belongs to one thread at a time.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/semantics/budgets.h"
#include "core/semantics/carry_over.h"
#include "core/semantics/context.h"
#include "core/semantics/force.h"
#include "core/semantics/order.h"
#include "core/semantics/program.h"
#include "core/semantics/recorder.h"
#include "core/semantics/why.h"

namespace race::semantics {

enum class Status : std::uint8_t { running, ended, faulted, aborted };
std::string_view name(Status status);

/// Why a run is faulted (R4): what, the state in whose scope, and where in its code.
struct RunFault {
  language::FaultKind kind;
  std::string at;
  std::string message;
  SourceRange where;
};

/// What is wrong with `arguments` for the parameters of the root, by name, each at `arguments/NAME`: `unknown_name` for
/// one that names no parameter, `constant` for one that is not finite.
std::vector<Error> check_arguments(const Program& program, const Dict& arguments);

class Run {
 public:
  /// A run of `program` that has not begun. `arguments` override the parameters of the root by name. Error: the first
  /// of check_arguments().
  static Expected<Run> create(std::shared_ptr<const Program> program, const Dict& arguments, Budgets budgets = {});
  Run(const Run& other);
  Run& operator=(const Run& other);
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;
  ~Run();

  // Inputs (section 3).
  /// The response to call `number` as an input: a result or an error. Nothing if it would not count.
  std::optional<Input> response(std::uint64_t number, bool is_error, Value data) const;
  /// Whether the run takes `input`: it is running, and the input is an occurrence of an event that the model names, or
  /// a response that it reads to a call that can be answered: the latest of its caller, once.
  bool counts(const Input& input) const;
  /// Whose operation a response that counts is about.
  const std::string& service_of(const Input& response) const;
  /// The call `number` of the operation, or its latest one for 0, if it can be answered or has been; else 0.
  std::uint64_t find_call(std::string_view service, std::string_view operation, std::uint64_t number = 0) const;
  /// The unanswered calls, in order of call: all, or those to `service`.
  std::vector<std::uint64_t> unanswered_calls(std::optional<std::string_view> service = {}) const;

  // One macro step: begin, micro until it returns false.
  /// Σ' (3.33): with an input, the snapshot takes it over; without, it stays. Requires status running, and that the
  /// input counts.
  void begin(std::optional<Input>&& input);
  /// One micro step (3.31). False when nothing happened (R14), which ends the macro step, or the run is no longer
  /// running.
  template <Recorder R>
  bool micro(R& recorder) {
    return micro_step(recorder, Order::declared());
  }
  /// The same in an order of ports, actions and children that need not be the declared one, nor that of the micro step
  /// before. Requires that it fits the program.
  template <VisitsAll R>
  bool micro(R& recorder, const Order& order) {
    return micro_step(recorder, order);
  }
  /// Micro steps until one changes nothing or the run is over (true), or until `limit` are done or `go_on`, which is
  /// asked after each, says false. Requires that the order fits the program and is declared unless R visits all.
  //
  // Quiesc (3.32): micro steps until none changes anything (R14).
  //
  //   Σ ⊢ Δ ⟹* Δ'    Δ' is ⟹-normal-form
  //   ────────────────────────────────────
  //   Σ ⊢ Δ ⟹↓ Δ'
  template <Recorder R, typename GoOn>
  bool quiesce(R& recorder, const Order& order, std::uint32_t limit, GoOn go_on) {
    while (limit-- > 0) {
      if (!micro_step(recorder, order)) return true;
      if (!go_on()) break;
    }
    return status() != Status::running;
  }
  // Edits (section 9): the run as a macro step of its own begins, which delivers the edit. Each requires status
  // running, that no macro step is open and no output waits.
  /// The run with an edited program; or what the edit waits for: what `program` has no place for.
  tl::expected<Run, std::vector<Obstacle>> edited(std::shared_ptr<const Program> program) const;
  /// The run with a value that somebody has set, or a port through which an active state is to be left: R24. Errors, at
  /// the path of the state: `not_found`; `conflict`, the state of the port is not active; `constant`, the value is not
  /// finite; `too_large`, it is beyond the budget.
  Expected<Run> forced(const Force& force) const;
  /// Ends the run between macro steps: no exit function runs; safe_calls() are made.
  void abort();
  /// A call of each operation marked `safe` of the services that the run has called, in order of their first call; with
  /// the numbers that the run's next calls would have.
  std::vector<OutgoingCall> safe_calls() const;

  /// As Limits::stop of the interpreter, from now on. null: nobody stops it.
  void stop_with(const std::atomic<bool>* stop);
  /// What the run has come to since is to be thrown away.
  bool is_told_to_stop() const;

  Status status() const;
  /// The port by which the root was left. Empty unless ended.
  const std::string& outcome() const;
  const std::optional<RunFault>& fault() const;
  /// Macro steps begun.
  std::uint64_t position() const;
  /// The calls of complete micro steps since the last time, in order, and what functions printed, for people: in place
  /// of what is in `calls` and `printed`.
  void take_output(std::vector<OutgoingCall>& calls, std::vector<std::string>& printed);

  /// Units (Value::size_units) of what it keeps of inputs: the newest data of each event, and the responses that count.
  std::uint64_t service_data_units() const;

  const Program& program() const;
  const RunState& state() const;
  /// Active nodes, ports, arrivals and values: the `state` of core/SEMANTICS.md section 7.
  Value state_json() const;
  bool is_active(StateId s) const;

  /// The run between macro steps: the `run` of schemas/checkpoint.json, by names alone. It has what differs from a new
  /// run, so it is as large as what has been active. What it shares with the run is not frozen. Requires that no macro
  /// step is open and no output waits.
  Value checkpoint_json() const;
  /// The run whose checkpoint_json() is `json`, with the same program, arguments and budgets. Errors, at paths that
  /// begin with `path`: those of Fields and create(); `unknown_name`; `out_of_range`; `duplicate`; `conflict`: parts
  /// that contradict each other, such as an active state whose parent is not active.
  static Checked<Run> read_checkpoint(std::shared_ptr<const Program> program, const Dict& arguments, Budgets budgets,
                                      const Value& json, const std::string& path);

  /// As things stand. Changes nothing.
  Why why(const Subject& subject);
  /// As they are when its turn comes in the next micro step, after what that does before. Nothing: there is no next
  /// one, or it does not come to it. Changes nothing.
  std::optional<Why> why_at_turn(const Subject& subject) const;
  /// A condition of somebody who watches (scope.h), evaluated as it stands in the scope of `s`, as a port of it would.
  /// Changes nothing.
  language::Truth truth(const Code& condition, StateId s);

 private:
  struct Body;
  explicit Run(std::unique_ptr<Body> body);
  template <Recorder R>
  bool micro_step(R& recorder, const Order& order);
  std::unique_ptr<Body> carried_body(std::shared_ptr<const Program> program, const Correspondence& same) const;
  void complete_micro_step();
  bool is_occurrence_hidden(StateId s) const;
  WhyPort why_port(PortId port);
  WhyAction why_action(ActionOf subject);
  WhyParameter why_parameter(ParameterOf subject);
  std::optional<language::Fault> unmet(ActionOf subject) const;
  void end();
  void fail(RunFault fault);
  void fail_at_root(language::FaultKind kind, std::string message);
  [[gnu::noinline, gnu::cold]] void fail_as_told();
  [[gnu::noinline, gnu::cold]] void fail_by_divergence();
  [[gnu::noinline, gnu::cold]] void fail_over_data_budget();
  std::unique_ptr<Body> body_;
};

}  // namespace race::semantics
