#include "core/semantics/run.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/semantics/micro.h"
#include "core/semantics/run_internal.h"
#include "core/value/error_list.h"

namespace race::semantics {

std::string_view name(Status status) {
  static constexpr std::array kNames = {"running", "ended", "faulted", "aborted"};
  return kNames[static_cast<std::size_t>(status)];
}

Run::Run(std::unique_ptr<Body> body) : body_(std::move(body)) {}
Run::Run(const Run& other) : body_(std::make_unique<Body>(*other.body_)) {}
Run& Run::operator=(const Run& other) {
  body_ = std::make_unique<Body>(*other.body_);
  return *this;
}
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

namespace {

struct Bound {
  std::vector<Value> values;  // by parameter of the root; unknown: none given
  std::vector<Error> errors;
};

Bound bind(const Program& program, const Dict& arguments) {
  const auto& parameters = program[Program::root].parameters;
  Bound bound{std::vector<Value>(parameters.size(), Value::unknown()), {}};
  for (const auto& [key, value] : arguments) {
    const std::string& name = key.as_string();
    const auto parameter = std::ranges::find(parameters, name, &ParameterInfo::name);
    if (parameter == parameters.end())
      add_error(bound.errors,
                {ErrorCode::unknown_name, "the task has no parameter `" + name + "`", "arguments/" + name});
    else if (!value.is_finite())
      add_error(bound.errors, {ErrorCode::constant, "the argument is not finite", "arguments/" + name});
    else
      bound.values[static_cast<std::size_t>(parameter - parameters.begin())] = value;
  }
  return bound;
}

}  // namespace

std::vector<Error> check_arguments(const Program& program, const Dict& arguments) {
  return bind(program, arguments).errors;
}

Expected<Run> Run::create(std::shared_ptr<const Program> program, const Dict& arguments, Budgets budgets) {
  Bound bound = bind(*program, arguments);
  if (!bound.errors.empty()) return tl::unexpected(std::move(bound.errors.front()));
  auto body = std::make_unique<Body>(std::move(program), budgets);
  body->arguments = std::move(bound.values);
  body->state.small_budget = budgets.evaluation.steps < language::kSmallBudget;
  return Run(std::move(body));
}

// REFINEMENT R4, R14: a micro step that ends in a fault is discarded; one that changes nothing is none.
template <Recorder R>
bool Run::micro_step(R& recorder, const Order& order) {
  Body& b = *body_;
  assert(order.fits(*b.program) && (R::kVisitsAll || order.is_declared()));
  if (b.status != Status::running) return false;
  if (b.budgets.evaluation.is_told_to_stop()) [[unlikely]] {
    fail_as_told();
    return false;
  }
  const bool reevaluates_all = R::kReevaluatesAll || (R::kVisitsAll && !order.is_declared());
  if (!reevaluates_all && b.state.started && b.state.work_set.empty()) return false;  // OPTIMIZATION: it is idle
  b.work.log.clear();
  b.work.outgoing.clear();
  const auto mark = recorder.mark();
  try {
    Step<R> step(*b.program, b.state, b.work, b.environment, b.interpreter, recorder, order);
    Micro(step, b.arguments);
    if (!step.changed) {
      recorder.discard(mark);
      return false;
    }
    if (changes_data(b.state, b.work.log.values)) [[unlikely]]
      count_data(b.state, b.work.log.values, b.work.changed);
  } catch (const FaultSignal& signal) {
    recorder.discard(mark);
    b.environment.clear_calls();
    fail({signal.fault.kind, b.program->node_path(signal.at), signal.fault.message, signal.fault.where});
    return false;
  }
  if (++b.micro_steps > b.budgets.micro_steps) {
    recorder.discard(mark);
    fail_by_divergence();
    return false;
  }
  if (b.state.data_units > b.budgets.data_units) [[unlikely]] {
    recorder.discard(mark);
    fail_over_data_budget();
    return false;
  }
  recorder.complete_micro_step(mark);
  // OPTIMIZATION: most micro steps call nothing and leave the root active.
  if (!b.work.outgoing.empty() || !is_active(Program::root)) [[unlikely]]
    complete_micro_step();
  return true;
}

template bool Run::micro_step(NoRecorder&, const Order&);
template bool Run::micro_step(NameRecorder&, const Order&);
template bool Run::micro_step(TreeRecorder&, const Order&);

// The calls leave the run (R16); a root that is left ends it, with the port by which it was left.
void Run::complete_micro_step() {
  Body& b = *body_;
  for (OutgoingCall& call : b.work.outgoing) {
    if (std::ranges::find(b.state.services_called, call.service) == b.state.services_called.end())
      b.state.services_called.push_back(call.service);
    b.outgoing.push_back(std::move(call));
  }
  if (!is_active(Program::root)) end();
}

void Run::end() {
  Body& b = *body_;
  b.status = Status::ended;
  for (const PortId p : (*b.program)[Program::root].ports)
    if (b.state.flags[b.program->flag(p)]) b.outcome = (*b.program)[p].name;
}

// REFINEMENT R4: the micro step is discarded, the run keeps its state for inspection, and what is safe is called.
void Run::fail(RunFault fault) {
  body_->work.log.undo(body_->state);
  body_->status = Status::faulted;
  body_->fault = std::move(fault);
  body_->make_safe_calls(safe_calls());
}

void Run::fail_at_root(language::FaultKind kind, std::string message) {
  fail({kind, program()[Program::root].path, std::move(message), {}});
}

void Run::stop_with(const std::atomic<bool>* stop) {
  body_->budgets.evaluation.stop = stop;
  body_->interpreter.set_limits(body_->budgets.evaluation);
}

bool Run::is_told_to_stop() const { return body_->budgets.evaluation.is_told_to_stop(); }

void Run::fail_as_told() { fail_at_root(language::FaultKind::budget, "told to stop"); }

void Run::fail_by_divergence() {
  fail_at_root(language::FaultKind::divergence,
               "more than " + std::to_string(body_->budgets.micro_steps) + " micro steps in one macro step");
}

void Run::fail_over_data_budget() {
  fail_at_root(language::FaultKind::budget,
               "the values of the run have more than " + std::to_string(body_->budgets.data_units) + " units");
}

void Run::abort() {
  if (body_->status != Status::running) return;
  ++body_->position;
  body_->status = Status::aborted;
  body_->make_safe_calls(safe_calls());
}

std::vector<OutgoingCall> Run::safe_calls() const {
  std::vector<OutgoingCall> calls;
  std::uint64_t number = body_->state.call_count;
  const auto& operations = body_->program->services.operations();
  for (const std::string& service : body_->state.services_called)
    for (OperationId o = 0; o < operations.size(); ++o)
      if (operations[o].safe && operations[o].service == service)
        calls.push_back({++number, o, service, operations[o].name, {}, {}, kNoState});
  return calls;
}

Status Run::status() const { return body_->status; }
const std::string& Run::outcome() const { return body_->outcome; }
const std::optional<RunFault>& Run::fault() const { return body_->fault; }
std::uint64_t Run::position() const { return body_->position; }
namespace {

template <typename T>
[[gnu::noinline]] void take_all(std::vector<T>& to, std::vector<T>& from) {
  to.clear();
  to.swap(from);
}

}  // namespace

// OPTIMIZATION: most steps have neither.
void Run::take_output(std::vector<OutgoingCall>& calls, std::vector<std::string>& printed) {
  if (!calls.empty() || !body_->outgoing.empty()) [[unlikely]]
    take_all(calls, body_->outgoing);
  if (!printed.empty() || !body_->environment.printed.empty()) [[unlikely]]
    take_all(printed, body_->environment.printed);
}
const Program& Run::program() const { return *body_->program; }
const RunState& Run::state() const { return body_->state; }
bool Run::is_active(StateId s) const { return body_->state.flags[body_->program->flag(s)] != 0; }

// REFINEMENT R21: whether the ports of `s` do not see the occurrence.
bool Run::is_occurrence_hidden(StateId s) const {
  const RunState& state = body_->state;
  return state.occurrence != kNone && state.live[index(s)].activated_in == state.epoch;
}

language::Truth Run::truth(const Code& condition, StateId s) {
  Body& b = *body_;
  b.environment.enter(s, !is_occurrence_hidden(s));
  return b.interpreter.condition(condition, b.environment);
}

}  // namespace race::semantics
