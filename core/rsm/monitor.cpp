#include "core/rsm/monitor.h"

#include <algorithm>

#include "core/rsm/type.h"
#include "core/value/expected.h"

namespace race::rsm {
namespace {

void add(Monitor::Violations& out, std::string_view rule, std::string message, Monitor::CallId call) {
  out.push_back(Violation{std::string(rule), std::move(message), call});
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Violations: arguments without a parameter, arguments of another type, parameters without an argument.
void check_arguments(const Operation& operation, const List& args, const Dict& kwargs, Monitor::CallId call,
                     Monitor::Violations& out) {
  const auto& parameters = operation.parameters;
  if (args.size() > parameters.size())
    add(out, "type",
        quote(operation.name) + " takes " + std::to_string(parameters.size()) + " arguments, got " +
            std::to_string(args.size()),
        call);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const OperationParameter& parameter = parameters[i];
    const Value* value = i < args.size() ? &args[i] : kwargs.find(std::string_view(parameter.name));
    const bool needed = !parameter.value && !parameter.type.find("optional");
    if (!value && needed) add(out, "type", "argument " + quote(parameter.name) + " is missing", call);
    const auto reason = value ? mismatch(parameter.type, *value) : std::nullopt;
    if (reason) add(out, "type", "argument " + quote(parameter.name) + ": " + *reason, call);
  }
  for (const auto& [key, value] : kwargs) {
    const bool known = std::any_of(parameters.begin(), parameters.end(),
                                   [&](const OperationParameter& p) { return p.name == key.as_string(); });
    if (!known) add(out, "type", quote(operation.name) + " has no parameter " + quote(key.as_string()), call);
  }
}

}  // namespace

Monitor::Monitor(Service service) : service_(std::move(service)), instance_(initial(service_)) {}

void Monitor::restarted() {
  instance_ = initial(service_);
  open_.clear();
  unannounced_.clear();
  last_transition_.clear();
  superseded_ = 0;
}

std::vector<Monitor::CallId> Monitor::open_calls() const {
  std::vector<CallId> out;
  for (const auto& [call, open] : open_) out.push_back(call);
  return out;
}

const Operation* Monitor::operation(std::string_view name) const {
  for (const Operation& operation : service_.operations) {
    if (operation.name == name) return &operation;
  }
  return nullptr;
}

const Event* Monitor::declared_event(std::string_view name) const {
  for (const Event& event : service_.events) {
    if (event.name == name) return &event;
  }
  return nullptr;
}

Monitor::Violations Monitor::called(CallId call, std::string_view name, const List& args, const Dict& kwargs) {
  Violations out;
  const Operation* called = operation(name);
  if (called) {
    check_arguments(*called, args, kwargs, call, out);
  } else {
    add(out, "declared", "there is no operation " + quote(name), call);
  }
  // An interface declares no transitions: each call may be answered at once.
  const auto progress = service_.is_interface() ? OpenCall::Progress::resolved : OpenCall::Progress::delivered;
  open_[call] = OpenCall{std::string(name), progress, std::nullopt};
  return out;
}

Monitor::Violations Monitor::transition(std::string_view id, CallId call) {
  Violations out;
  superseded_ = 0;
  check_unannounced(out);
  const Transition* t = find_transition(service_, id);
  if (!t) {
    add(out, "declared", "there is no transition " + quote(id), call);
    return out;
  }
  check_source(*t, call, out);
  follow(*t, call);
  return out;
}

// Trans1 and Trans2, the premises: t.src = svc.cur ∪ ∅, and α = t.operation or t.operation = ∅.
void Monitor::check_source(const Transition& t, CallId call, Violations& out) const {
  const std::string_view rule = t.operation ? "Trans1" : "Trans2";
  if (!leaves_current(t, instance_))
    add(out, rule, quote(t.id) + " leaves " + quote(*t.src) + ", the state is " + quote(instance_.current), call);
  if (!t.operation) {
    if (call != 0 && !answers_one(service_, instance_, t, call))
      add(out, rule, quote(t.id) + " waits for no call and answers no such one, but was taken on it", call);
    return;
  }
  const auto open = open_.find(call);
  if (open == open_.end() || open->second.progress != OpenCall::Progress::delivered) {
    add(out, rule, quote(t.id) + " was taken on no call that waits", call);
  } else if (open->second.operation != *t.operation) {
    add(out, rule, quote(t.id) + " waits for " + quote(*t.operation) + ", called was " + quote(open->second.operation),
        call);
  } else if (const Transition* first = taken_on(service_, instance_, *t.operation);
             first && first->id != t.id && leaves_current(t, instance_)) {
    add(out, rule, "the call takes " + quote(first->id) + ", which is declared first, not " + quote(t.id), call);
  }
}

// Trans1 and Trans2, the conclusion: cur = t.dst, and the calls that t resolves may be answered.
void Monitor::follow(const Transition& t, CallId call) {
  instance_.current = t.dst;
  last_transition_ = t.id;
  unannounced_.insert(t.events.begin(), t.events.end());
  if (t.operation && open_.contains(call)) {
    const auto earlier = instance_.pending.find(t.id);
    // REFINEMENT R17: the earlier call that took t has no response any more.
    if (!t.concurrent && earlier != instance_.pending.end() && earlier->second.front() != call)
      superseded_ = earlier->second.front();
    open_.erase(superseded_);
    add_pending(instance_, t, call);
    open_[call].progress = OpenCall::Progress::deferred;
  }
  for (const Answer& answer : respond(service_, instance_, t, t.operation ? 0 : call)) {
    const auto open = open_.find(answer.call);
    if (open == open_.end()) continue;  // two transitions were taken on it, which has been reported
    open->second.progress = OpenCall::Progress::resolved;
    if (answer.is_error) open->second.error_code = answer.error_code;
  }
}

void Monitor::check_unannounced(Violations& out) {
  for (const std::string& name : unannounced_)
    add(out, "put", quote(last_transition_) + " puts the event " + quote(name) + ", which was not announced", 0);
  unannounced_.clear();
}

Monitor::Violations Monitor::rejected(CallId call) {
  Violations out;
  const auto open = open_.find(call);
  if (open == open_.end() || open->second.progress == OpenCall::Progress::deferred) {
    add(out, "R7", "rejected a call that does not wait", call);
  } else if (const Transition* t = taken_on(service_, instance_, open->second.operation)) {
    add(out, "R7", "rejected a call that " + quote(instance_.current) + " takes by " + quote(t->id), call);
  }
  if (open != open_.end()) close(open);
  return out;
}

// A call that is answered too early (a violation) has no response to come.
Monitor::OpenCall Monitor::close(OpenCalls::iterator call) {
  if (call->second.progress == OpenCall::Progress::deferred) drop_pending(instance_, call->first);
  OpenCall closed = std::move(call->second);
  open_.erase(call);
  return closed;
}

std::optional<Monitor::OpenCall> Monitor::answer(CallId call, Violations& out) {
  const auto found = open_.find(call);
  if (found == open_.end()) {
    add(out, "respond",
        "response to a call that is not open (answered already, superseded by a later one (R17), or none)", call);
    return std::nullopt;
  }
  OpenCall open = close(found);
  if (open.progress == OpenCall::Progress::delivered)
    add(out, "respond", "response to " + quote(open.operation) + " before a transition took the call", call);
  if (open.progress == OpenCall::Progress::deferred)
    add(out, "respond", "response to " + quote(open.operation) + ", which is deferred and not resolved yet", call);
  return open;
}

Monitor::Violations Monitor::result(CallId call, const Value& value) {
  Violations out;
  const auto open = answer(call, out);
  if (!open) return out;
  if (open->error_code)
    add(out, "respond", quote(open->operation) + " is resolved with the error " + quote(*open->error_code), call);
  const Operation* answered = operation(open->operation);
  const auto reason = answered ? mismatch(answered->result, value) : std::nullopt;
  if (reason) add(out, "type", "result of " + quote(open->operation) + ": " + *reason, call);
  return out;
}

Monitor::Violations Monitor::error(CallId call, const Value& value) {
  Violations out;
  const Value* code = value.find("code");
  if (!code || !code->is_string()) add(out, "type", "an error must be a dict with the string `code`", call);
  const auto open = answer(call, out);
  const Operation* answered = open ? operation(open->operation) : nullptr;
  if (!answered) return out;
  if (open->error_code) {
    if (code && *code != Value(*open->error_code))
      add(out, "respond", quote(open->operation) + " is resolved with the error " + quote(*open->error_code), call);
  } else if (answered->error.is_null()) {
    add(out, "declared", quote(open->operation) + " declares no error", call);
  } else if (const auto reason = mismatch(answered->error, value)) {
    add(out, "type", "error of " + quote(open->operation) + ": " + *reason, call);
  }
  return out;
}

Monitor::Violations Monitor::event(std::string_view name, const Value& data) {
  Violations out;
  const Event* event = declared_event(name);
  if (!event) {
    add(out, "declared", "there is no event " + quote(name), 0);
    return out;
  }
  if (const auto reason = mismatch(event->data, data)) add(out, "type", "event " + quote(name) + ": " + *reason, 0);
  if (const auto announced = unannounced_.find(name); announced != unannounced_.end()) {
    unannounced_.erase(announced);
  } else if (!service_.is_interface() && !contains(Stutter(service_, instance_).events, name)) {
    add(out, "Stutter", quote(instance_.current) + " does not emit the event " + quote(name), 0);
  }
  return out;
}

}  // namespace race::rsm
