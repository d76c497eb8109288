#include "api/cpp/race_client/hosted.h"

#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "api/cpp/race_client/say.h"
#include "api/cpp/race_client/values.h"
#include "core/language/primitives/utf8.h"
#include "core/value/fields.h"
#include "services/arguments.h"
#include "services/host/call_ledger.h"
#include "services/remote/protocol.h"

namespace race::client {
namespace {

constexpr std::size_t kLogBytes = 300;
constexpr std::size_t kWhatBytes = 500;  // of an exception, in an error

Value error(std::string_view code, std::string_view message) { return services::error_value(code, message); }

// A task branches on two codes, whatever library the service is written with.
Value argument_error(const Error& why) {
  const bool is_range = why.code == ErrorCode::out_of_range;
  Value made = error(is_range ? name(why.code) : "invalid", why.message);
  if (!why.path.empty()) made.mutable_dict().set("argument", why.path);
  return made;
}

const rsm::Transition* fitting(const std::vector<const rsm::Transition*>& transitions, const Value* code) {
  const rsm::Transition* of_result = nullptr;
  for (const rsm::Transition* each : transitions) {
    if (code && each->error == code->as_string()) return each;
    if (!each->error && !of_result) of_result = each;
  }
  return of_result;
}

// The transition that answers a call which `taken` took: with the error of this code, or with a result. nullptr: none.
const rsm::Transition* ending_of(const rsm::Service& service, const rsm::Instance& instance,
                                 const rsm::Transition& taken, const Value* code) {
  std::vector<const rsm::Transition*> all, here;
  for (const std::string& id : taken.defer) {
    const rsm::Transition* each = rsm::find_transition(service, id);
    if (!each || each->operation) continue;
    all.push_back(each);
    if (rsm::leaves_current(*each, instance)) here.push_back(each);
  }
  return fitting(here.empty() ? all : here, code);
}

}  // namespace

// The component of one connection.
class Hosted::Link final : public services::Component {
 public:
  explicit Link(Hosted& hosted) : hosted_(hosted) {}
  const rsm::Service& model() const override { return hosted_.model_; }
  void call(const services::Call& call) override { hosted_.called(call); }
  void step() override { hosted_.inbox_.run(); }
  void halt() override { hosted_.silent(); }
  void limit_speed(std::optional<double> tool_speed) override { hosted_.set_speed_limit(tool_speed); }
  void violated(const services::Violation& violation) override {
    const std::string place = place_of_text(hosted_.declaration_, violation.operation, violation.message),
                      call = violation.call == 0 ? "" : " (call " + std::to_string(violation.call) + ")";
    say(place + ": violation: " + violation.rule + ": " + violation.message + call);
  }

 private:
  Hosted& hosted_;
};

Hosted::~Hosted() {
  inbox_.close();
  for (const auto& [id, call] : calls_) workers_.end(*call);
}

std::unique_ptr<services::Component> Hosted::component(services::ServiceHost& host) {
  host_ = &host;
  return std::make_unique<Link>(*this);
}

void Hosted::connected() {
  instance_ = rsm::initial(model_);
  set_state(instance_.current);
  set_speed_limit({});  // it is said if there is one
  inbox_.open();
  const services::MutexLock lock(mutex_);
  is_connected_ = true;
}

void Hosted::lost() {
  {
    const services::MutexLock lock(mutex_);
    if (!std::exchange(is_connected_, false)) return;
    state_.clear();
  }
  inbox_.close();
  for (const auto& [id, call] : calls_) workers_.end(*call);
  calls_.clear();
  halt();
}

// ---- What it says by itself.

void Hosted::emit(std::string_view event, Value data) {
  if (!is_name(event) || event.size() > remote::kNameBytes)
    throw std::invalid_argument(quote(event) + " is no name of an event");
  if (const auto why = unsayable(data)) throw std::invalid_argument("the data of " + quote(event) + " " + *why);
  inbox_.post([this, name = std::string(event), data = frozen(std::move(data))] { host_->event(name, data); });
}

void Hosted::take(std::string_view transition) {
  {
    const services::MutexLock lock(mutex_);
    if (!is_connected_) return;
  }
  const rsm::Transition* const taken = rsm::find_transition(model_, transition);
  if (!taken) throw std::invalid_argument("the RSM has no transition " + quote(transition));
  inbox_.post([this, taken] { follow(*taken, 0, nullptr); });
}

void Hosted::log(std::string_view text) {
  std::string line(language::utf8::valid(text) ? language::utf8::prefix(text, kLogBytes) : "a text that is not UTF-8");
  inbox_.post([this, line = std::move(line)] { host_->log(line); });
}

std::string Hosted::state() const {
  const services::MutexLock lock(mutex_);
  return state_;
}

std::optional<double> Hosted::speed_limit() const {
  const services::MutexLock lock(mutex_);
  return speed_limit_;
}

void Hosted::set_state(const std::string& state) {
  const services::MutexLock lock(mutex_);
  state_ = state;
}

void Hosted::set_speed_limit(std::optional<double> limit) {
  const services::MutexLock lock(mutex_);
  speed_limit_ = limit;
}

// ---- Calls.

void Hosted::called(const services::Call& call) {
  const rsm::Operation* operation = services::find_operation(model_, call.operation);
  const rsm::Transition* taken = rsm::taken_on(model_, instance_, call.operation);
  if (!operation || (!taken && !model_.is_interface())) return host_->reject(call.id);
  const auto running = std::make_shared<RunningCall>(workers_, call.id, call.operation, taken);
  calls_[call.id] = running;
  if (taken) follow(*taken, call.id, nullptr);
  auto arguments = services::bind_arguments(*operation, call);
  if (!arguments) return answer(*running, {Value(), argument_error(arguments.error())});
  arguments->freeze();  // another thread gets them
  if (running->is_busy()) return run_busy(running, std::move(*arguments));
  answer(*running, run_handler(*running, std::move(*arguments)));
}

void Hosted::run_busy(const std::shared_ptr<RunningCall>& call, Dict arguments) {
  const auto refuse = [&](const std::string& why) { answer(*call, {Value(), error("too_many", why)}); };
  if (!workers_.has_room()) return refuse(std::to_string(Workers::kMost) + " calls are at work");
  try {
    workers_.start(call, [this, call, arguments = std::move(arguments)] {
      if (call->over) return;
      Outcome outcome = run_handler(*call, arguments);
      inbox_.post([this, call, outcome = std::move(outcome)] { answer(*call, outcome); });
    });
  } catch (const std::system_error& failure) {
    refuse(failure.what());
  }
}

// On the thread of the handler.
Hosted::Outcome Hosted::run_handler(RunningCall& running, Dict arguments) const {
  try {
    Call call(running, std::move(arguments));
    Value result = find_operation(declaration_, running.operation)->handler(call);
    if (const auto why = unsayable(result)) return failed(running.operation, "the result " + *why);
    return {frozen(std::move(result)), Value()};
  } catch (const Failure& failure) {
    if (const auto why = unsayable(failure.error())) return failed(running.operation, "the error " + *why);
    return {Value(), frozen(failure.error())};
  } catch (const Stopped&) {
    return {Value(), frozen(Dict{{"code", "stopped"}})};
  } catch (const std::exception& failure) {
    return failed(running.operation, failure.what());
  } catch (...) {
    return failed(running.operation, "it has thrown what is no std::exception");
  }
}

Hosted::Outcome Hosted::failed(const std::string& operation, const std::string& what) const {
  say(place_of(declaration_, {operation}) + ": error: " + quote(operation) + " has failed: " + what);
  const std::string_view known = language::utf8::valid(what) ? std::string_view(what) : "what it says is not UTF-8";
  return {Value(), frozen(error("failed", language::utf8::prefix(known, kWhatBytes)))};
}

// By the transition that is due, if it still waits for an answer.
void Hosted::answer(RunningCall& call, Outcome outcome) {
  if (call.over) return;
  if (call.transition && !call.transition->defer.empty()) {
    if (const rsm::Transition* ending = ending_of(model_, instance_, *call.transition, outcome.error.find("code")))
      follow(*ending, call.transition->concurrent ? call.id : 0, &call);
    rsm::drop_pending(instance_, call.id);
  }
  respond(call, std::move(outcome));
}

void Hosted::respond(RunningCall& call, Outcome outcome) {
  if (outcome.error.is_null())
    host_->result(call.id, std::move(outcome.result));
  else
    host_->error(call.id, std::move(outcome.error));
  finish(call);
}

// Nobody waits for its answer any more.
void Hosted::finish(RunningCall& call) {
  workers_.end(call);
  calls_.erase(call.id);
}

// Takes a transition, by the call `number` or to answer that one of several; other calls that it answers, but for
// `own` and the call that takes it, whose work begins, end (core/SEMANTICS.md section 5, resolve). So does the one
// whose place a call takes (R17).
void Hosted::follow(const rsm::Transition& transition, services::CallId number, const RunningCall* own) {
  host_->transition(transition.id, number);
  instance_.current = transition.dst;
  set_state(transition.dst);
  services::CallId superseded = 0;
  if (transition.operation && !transition.defer.empty()) {
    const auto pending = instance_.pending.find(transition.id);
    if (pending != instance_.pending.end() && !transition.concurrent) superseded = pending->second.back();
    rsm::add_pending(instance_, transition, number);
  }
  const auto due = rsm::respond(model_, instance_, transition, transition.operation ? 0 : number);
  for (const rsm::Answer& each : due) {
    const auto found = calls_.find(each.call);
    const bool begins = transition.operation && each.call == number;
    if (begins || found == calls_.end() || found->second.get() == own) continue;
    const std::shared_ptr<RunningCall> other = found->second;
    respond(*other, {Value(), each.is_error ? Value(Dict{{"code", each.error_code}}) : Value()});
  }
  if (const auto found = calls_.find(superseded); found != calls_.end()) {
    const std::shared_ptr<RunningCall> other = found->second;
    finish(*other);
  }
}

// ---- Nobody is there who could stop it.

void Hosted::silent() {
  const auto calls = calls_;
  for (const auto& [id, call] : calls)
    if (call->is_busy()) answer(*call, {Value(), error("stopped", "the server is silent")});
  halt();
}

void Hosted::halt() {
  if (!declaration_.on_halt) {
    for (const rsm::Operation& each : model_.operations)
      if (each.safe) halt_by(each);
    return;
  }
  try {
    declaration_.on_halt();
  } catch (const std::exception& failure) {
    say(place_of(declaration_, {}) + ": error: it cannot halt: " + failure.what());
  } catch (...) {
    say(place_of(declaration_, {}) + ": error: it cannot halt");
  }
}

void Hosted::halt_by(const rsm::Operation& operation) {
  auto arguments = services::bind_arguments(operation, {});
  if (!arguments)
    return say(place_of(declaration_, {operation.name}) + ": error: it cannot halt: " + arguments.error().message);
  RunningCall nobodys(workers_, 0, operation.name, nullptr);
  run_handler(nobodys, std::move(*arguments));
}

}  // namespace race::client
