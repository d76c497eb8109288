#include "core/semantics/run.h"

#include <algorithm>
#include <cassert>
#include <ranges>

#include "core/semantics/micro.h"

namespace race::semantics {

std::string_view name(Status status) {
  static constexpr std::array kNames = {"running", "ended", "faulted", "aborted"};
  return kNames[static_cast<std::size_t>(status)];
}

void StepLog::undo(RunState& run) {
  for (auto& [slot, value] : std::views::reverse(values)) run.values[slot] = std::move(value);
  for (const auto& [flag, value] : std::views::reverse(flags)) run.flags[flag] = value;
  for (const auto& [port, value] : std::views::reverse(arrived)) run.arrived[index(port)] = value;
  for (const auto& [port, value] : std::views::reverse(triggered)) run.triggered[index(port)] = value;
  for (LoggedCall& call : std::views::reverse(calls)) {
    --run.call_count;
    std::vector<CallRecord>& records = run.calls[call.operation];
    records.pop_back();
    if (call.before) records.insert(records.begin() + static_cast<std::ptrdiff_t>(call.place), std::move(*call.before));
  }
  clear();
}

struct Run::Body {
  Body(std::shared_ptr<const Program> p, Budgets b)
      : program(std::move(p)),
        budgets(b),
        state(*program),
        environment(*program, state, work.log.values),
        interpreter(b.evaluation) {}
  Body(const Body& other)
      : program(other.program),
        budgets(other.budgets),
        state(other.state),
        environment(*program, state, work.log.values),
        interpreter(other.budgets.evaluation),
        arguments(other.arguments),
        status(other.status),
        outcome(other.outcome),
        fault(other.fault),
        outgoing(other.outgoing),
        micro_steps(other.micro_steps),
        position(other.position) {}
  Body& operator=(const Body&) = delete;

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
      bound.errors.push_back(
          {ErrorCode::unknown_name, "the task has no parameter `" + name + "`", "arguments/" + name});
    else if (!value.is_finite())
      bound.errors.push_back({ErrorCode::constant, "the argument is not finite", "arguments/" + name});
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

bool Run::post_event(std::string_view service, std::string_view event, Value data) {
  const EventId id = body_->program->services.find_event(service, event);
  return id != kNone && post_event(id, std::move(data));
}

bool Run::post_event(EventId event, Value data) {
  if (body_->status != Status::running || !body_->program->names_event(event)) return false;
  std::deque<Input>& waiting = body_->state.waiting;
  // REFINEMENT R5: inputs wait in order of arrival; of a sampled event only the newest, at the end.
  if (body_->program->sampled[event])
    std::erase_if(waiting, [&](const Input& i) { return i.kind == Input::Kind::event && i.number == event; });
  waiting.push_back({Input::Kind::event, event, {}, 0, false, std::move(data)});
  return true;
}

namespace {

// The record that a response to call `number` would answer: only the latest call of each caller can be, once.
CallRecord* answerable(RunState& run, OperationId operation, std::uint64_t number) {
  for (CallRecord& record : run.calls[operation])
    if (record.number == number && !record.answered) return &record;
  return nullptr;
}

const std::string& callee(const Program& program, OperationId operation, const CallRecord& record) {
  return program.services.is_open(operation) ? record.service : program.services.operations()[operation].service;
}

}  // namespace

std::uint64_t Run::find_call(std::string_view service, std::string_view operation, std::uint64_t number) const {
  const OperationId id = body_->program->services.dynamic_operation(service, operation);
  if (id == kNone) return 0;
  for (const CallRecord& record : std::views::reverse(body_->state.calls[id]))
    if (callee(*body_->program, id, record) == service && (number == 0 || record.number == number))
      return record.number;
  return 0;
}

bool Run::post_response(std::uint64_t number, bool is_error, Value data) {
  if (body_->status != Status::running) return false;
  for (OperationId o = 0; o < body_->state.calls.size(); ++o) {
    const CallRecord* record = answerable(body_->state, o, number);
    if (!record) continue;
    if (!body_->program->names_response(o)) return false;
    body_->state.waiting.push_back({Input::Kind::response, o, record->service, number, is_error, std::move(data)});
    return true;
  }
  return false;
}

// REFINEMENT R7: a lost service answers every unanswered call with `unavailable`, in order of call.
void Run::post_lost(std::string_view service) {
  std::vector<std::uint64_t> unanswered;
  for (OperationId o = 0; o < body_->state.calls.size(); ++o)
    for (const CallRecord& record : body_->state.calls[o])
      if (!record.answered && callee(*body_->program, o, record) == service) unanswered.push_back(record.number);
  std::ranges::sort(unanswered);
  for (const std::uint64_t number : unanswered) post_response(number, true, Dict{{"code", "unavailable"}});
}

bool Run::has_input() const {
  if (body_->status != Status::running) return false;
  if (!body_->state.started) return true;
  return std::ranges::any_of(body_->state.waiting, [&](const Input& input) {
    return input.kind == Input::Kind::event || answerable(body_->state, input.number, input.call);
  });
}

// REFINEMENT R5, R6: the first waiting input that counts; a response that another call has overtaken does not.
std::optional<Input> Run::take_input() {
  std::deque<Input>& waiting = body_->state.waiting;
  while (!waiting.empty()) {
    Input input = std::move(waiting.front());
    waiting.pop_front();
    if (input.kind == Input::Kind::event || answerable(body_->state, input.number, input.call)) return input;
  }
  return std::nullopt;
}

// Macro (4.19): Σ' = Ω if updated(Ω,Σ), else Σ. REFINEMENT R15: missing requirements do not block it.
void Run::begin(std::optional<Input> input) {
  assert(body_->status == Status::running);
  RunState& run = body_->state;
  const Program& program = *body_->program;
  body_->micro_steps = 0;
  ++body_->position;
  if (!input) return;
  ++run.epoch;  // `executed`, `triggered` and the states activated in this macro step are empty
  const bool active = run.flags[program.flag(Program::root)] != 0;
  for (const StateId s : run.recheck) {
    run.live[index(s)].recheck = false;
    if (run.flags[program.flag(s)]) wake(run, s);
  }
  run.recheck.clear();
  const EventId before = std::exchange(run.occurrence, kNone);
  if (input->kind == Input::Kind::event) {
    run.occurrence = input->number;
    run.event_data[input->number] = std::move(input->data);
    run.event_tick[input->number] = ++run.tick;
    if (active) wake_event_readers(run, program, input->number);
  } else {
    CallRecord* record = answerable(run, input->number, input->call);
    assert(record);
    record->answered = true;
    record->is_error = input->is_error;
    record->response = std::move(input->data);
    run.response_tick[input->number] = ++run.tick;
    if (active) wake_response_readers(run, program, input->number);
  }
  if (active && before != kNone && before != run.occurrence) wake_event_readers(run, program, before);
}

namespace {

// R13: the parameters of the root are the run's arguments over its own values.
template <Recorder R>
void resolve_root(Step<R>& step, const std::vector<Value>& arguments) {
  for (std::uint32_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is_unknown()) {
      Resolve(step, Program::root, i);
      continue;
    }
    OpenNode<R> node = step.apply(Rule::Resolve, Program::root);
    if constexpr (R::kTree) {
      node.node().detail = static_cast<std::uint32_t>(step.recorder.derivation.resolved.size());
      step.recorder.derivation.resolved.push_back({i, arguments[i]});
    }
    step.environment.write(step.program[Program::root].parameter_slot + i, arguments[i]);
  }
}

}  // namespace

// Micro (3.31): the micro rule of the root. REFINEMENT R13: the very first micro step activates it.
template <Recorder R>
void Run::micro_transition(R& recorder, bool& changed) {
  Body& b = *body_;
  Step<R> step(*b.program, b.state, b.work, b.environment, b.interpreter, recorder);
  OpenNode<R> rule = step.apply(Rule::Micro, Program::root);
  if (!b.state.started) {
    rule.refinement(13);
    resolve_root(step, b.arguments);
    SAct1(step, Program::root, kNoPort);
    b.state.started = true;
    changed = true;
    return;
  }
  if (step.is_active(Program::root)) visit_root(step);
  changed = step.changed;
}

template <Recorder R>
bool Run::micro(R& recorder) {
  Body& b = *body_;
  if (b.status != Status::running) return false;
  if constexpr (!R::kLooksAgain)  // OPTIMIZATION: it would be idle
    if (b.state.started && b.state.hot.empty()) return false;
  std::size_t mark = 0;
  if constexpr (R::kTree) mark = recorder.derivation.nodes.size();
  if constexpr (R::kRecords && !R::kTree) mark = recorder.names.size();
  const auto forget = [&] {
    if constexpr (R::kTree) recorder.derivation.nodes.resize(mark);
    if constexpr (R::kRecords && !R::kTree) recorder.names.resize(mark);
  };
  b.work.log.clear();
  b.work.outgoing.clear();
  bool changed = false;
  const bool first = !b.state.started;
  try {
    micro_transition(recorder, changed);
  } catch (const FaultSignal& signal) {
    forget();
    b.work.log.undo(b.state);
    b.environment.calls.clear();
    b.state.started = !first;
    fail({signal.fault.kind, b.program->node_path(signal.at), signal.fault.message, signal.fault.where});
    return false;
  }
  if (!changed) {
    forget();
    return false;
  }
  if (++b.micro_steps > b.budgets.micro_steps) {
    forget();
    b.work.log.undo(b.state);
    fail({language::FaultKind::divergence,
          (*b.program)[Program::root].path,
          "more than " + std::to_string(b.budgets.micro_steps) + " micro steps in one macro step",
          {}});
    return false;
  }
  if constexpr (R::kTree) recorder.derivation.micro.push_back(static_cast<std::uint32_t>(mark));
  if constexpr (R::kRecords && !R::kTree) recorder.micro.push_back(static_cast<std::uint32_t>(mark));
  for (OutgoingCall& call : b.work.outgoing) {
    if (std::ranges::find(b.state.services_called, call.service) == b.state.services_called.end())
      b.state.services_called.push_back(call.service);
    b.outgoing.push_back(std::move(call));
  }
  if (!b.state.flags[b.program->flag(Program::root)]) {
    b.status = Status::ended;
    for (const PortId p : (*b.program)[Program::root].ports)
      if (b.state.flags[b.program->flag(p)]) b.outcome = (*b.program)[p].name;
  }
  return true;
}

template bool Run::micro(NoRecorder&);
template bool Run::micro(NameRecorder&);
template bool Run::micro(TreeRecorder&);

// REFINEMENT R4: the step is discarded, the run keeps its state for inspection, and what is safe is called.
void Run::fail(RunFault fault) {
  body_->status = Status::faulted;
  body_->fault = std::move(fault);
  body_->state.waiting.clear();
  call_safe_operations();
}

void Run::abort() {
  if (body_->status != Status::running) return;
  ++body_->position;
  body_->status = Status::aborted;
  body_->state.waiting.clear();
  call_safe_operations();
}

void Run::call_safe_operations() {
  const auto& operations = body_->program->services.operations();
  for (const std::string& service : body_->state.services_called)
    for (OperationId o = 0; o < operations.size(); ++o)
      if (operations[o].safe && operations[o].service == service)
        body_->outgoing.push_back({++body_->state.call_count, o, service, operations[o].name, {}, {}, kNoState});
}

Status Run::status() const { return body_->status; }
const std::string& Run::outcome() const { return body_->outcome; }
const std::optional<RunFault>& Run::fault() const { return body_->fault; }
std::uint64_t Run::position() const { return body_->position; }
std::vector<OutgoingCall> Run::take_calls() { return std::exchange(body_->outgoing, {}); }
std::vector<std::string> Run::take_printed() { return std::exchange(body_->environment.printed, {}); }
const Program& Run::program() const { return *body_->program; }
const RunState& Run::state() const { return body_->state; }
bool Run::is_active(StateId s) const { return body_->state.flags[body_->program->flag(s)] != 0; }

Run::Why Run::why(PortId port) {
  Body& b = *body_;
  const PortInfo& info = (*b.program)[port];
  Why why;
  why.state_active = is_active(info.state);
  why.occurrence_hidden = b.state.occurrence != kNone && b.state.live[index(info.state)].activated_in == b.state.epoch;
  b.environment.enter(info.state, !why.occurrence_hidden);
  why.explanation = language::explain(info.when, b.environment);
  why.held_back =
      info.svc && b.state.triggered[index(port)] == b.state.epoch && why.explanation.value == language::Truth::yes;
  return why;
}

}  // namespace race::semantics
