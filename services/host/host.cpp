#include "services/host/host.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <tuple>
#include <utility>

#include "services/arguments.h"

namespace race::services {
namespace {

// Returns their units (Value::size_units).
std::size_t freeze(List& args, Dict& kwargs) {
  std::size_t units = 0;
  for (Value& argument : args) units += argument.freeze().size_units();
  kwargs.freeze();
  for (const auto& [key, value] : kwargs) units += key.size_units() + value.size_units();
  return units;
}

std::string of_call(CallId call) { return call == 0 ? std::string() : " (call " + std::to_string(call) + ')'; }

// Of the calls of a core: an odd number. Packets, and what is due, wait for no calls.
WorkQueue::Lane lane_of(const std::string& core) {
  return core.empty() ? WorkQueue::kNoLane : std::hash<std::string>{}(core) | 1U;
}

}  // namespace

class Host::Endpoint final : public ServiceHost {
 public:
  Endpoint(Host& host, std::size_t number) : host_(host), number_(number) {}

  Time now() const override { return host_.clock_.now(); }
  void transition(std::string_view id, CallId call) override { host_.transition(number_, id, call); }
  void result(CallId call, Value value) override { host_.respond(number_, call, {std::move(value), false}); }
  void error(CallId call, Value error) override { host_.respond(number_, call, {std::move(error), true}); }
  void reject(CallId call) override { host_.reject(number_, call); }
  void event(std::string_view name, Value data) override { host_.event(number_, name, std::move(data)); }
  void publish(std::string_view flow, PacketPtr packet) override { host_.publish(number_, flow, packet); }
  void subscribe(std::string_view key, std::string_view flow, bool on) override {
    host_.subscribe(number_, key, flow, on);
  }
  ReservationId reserve(Time at) override { return host_.reservations_.reserve(number_, at); }
  void fulfil(ReservationId reservation, std::function<void()> answer) override {
    host_.reservations_.fulfil(reservation, std::move(answer));
  }
  void log(std::string text) override { host_.log(number_, text); }

 private:
  Host& host_;
  const std::size_t number_;
};

Host::Host(const Clock& clock, HostObserver& observer, MotionGate* gate)
    : clock_(clock), observer_(observer), gate_(gate ? *gate : open_gate_) {}
Host::~Host() = default;

ServiceHost& Host::declare(std::string key, std::string type, WorkQueue& queue) {
  const MutexLock lock(mutex_);
  auto entry = std::make_unique<ServiceEntry>(entries_.size(), std::move(key), std::move(type), queue);
  entry->host = std::make_unique<Endpoint>(*this, entry->number);
  entries_.push_back(std::move(entry));
  const MutexLock keys_lock(keys_mutex_);
  by_key_.emplace(entries_.back()->status.key, entries_.back().get());
  return *entries_.back()->host;
}

// ---- Calls.

Host::Response Host::Response::unavailable() { return {Dict{{"code", Value(name(ErrorCode::unavailable))}}, true}; }

CallId Host::call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs,
                  const std::string& after, std::uint64_t supersedes) {
  const std::size_t units = freeze(args, kwargs);
  const CallId id = next_call_++;
  const WorkQueue::Lane lane = lane_of(caller.core.empty() ? after : caller.core);
  PendingCall pending{id, operation, clock_.now(), std::move(caller), units};
  ServiceEntry* entry = find(service);
  if (!entry || !entry->arriving.add(units, pending.caller.core.empty())) {
    const MutexLock lock(mutex_);
    if (entry)
      refuse_more(pending, *entry);
    else
      refuse(pending, service, "there is no such service");
    answer_unavailable(pending, service);
    return id;
  }
  auto arrival = [this, entry, disconnections = entry->disconnections.load(), pending = std::move(pending),
                  call = Call{id, std::move(operation), std::move(args), std::move(kwargs)}, supersedes] {
    entry->arriving.remove(pending.units);
    if (supersedes != 0) run(entry->number, disconnections, abandoning(*entry, {pending.caller.core, supersedes}));
    arrive(*entry, disconnections, pending, call);
  };
  try {
    entry->queue.post(std::move(arrival), lane);
  } catch (...) {
    entry->arriving.remove(units);
    throw;
  }
  return id;
}

void Host::arrive(ServiceEntry& entry, std::uint64_t disconnections, const PendingCall& pending, const Call& call) {
  if (accept(entry, disconnections, pending, call))
    run(entry.number, disconnections, [&call](Component& component) { component.call(call); });
}

// What is not accepted is answered. So is what was on its way when the component was disconnected, and that for which
// there is no memory.
bool Host::accept(ServiceEntry& entry, std::uint64_t disconnections, const PendingCall& pending, const Call& call) {
  const MutexLock lock(mutex_);
  try {
    if (entry.disconnections == disconnections && can_be_called(pending, entry)) {
      if (auto refused = refuse_motion(pending, entry))
        return deliver_response(entry, pending, {std::move(*refused), true}), false;
      log(entry, entry.ledger->call(pending, call.args, call.kwargs));
      notify_status(entry);
      return true;
    }
  } catch (const std::exception&) {
    std::ignore = entry.ledger->take(pending.id);
  }
  answer_unavailable(pending, entry.status.key);
  return false;
}

void Host::abandon(const Caller& caller) {
  const MutexLock lock(mutex_);
  for (const auto& entry : entries_)
    if (entry->ledger) post(*entry, abandoning(*entry, caller), lane_of(caller.core));
}

void Host::abandon_all(const std::string& core) {
  const MutexLock lock(mutex_);
  for (const auto& entry : entries_) {
    if (entry->ledger) post(*entry, abandoning(*entry, {core, 0}), lane_of(core));
    entry->queue.post([this, key = entry->status.key, core] { gate_.release(core, key); }, lane_of(core));
  }
}

void Host::call_safe() {
  call_safe_of([](const std::string&) { return true; });
}

void Host::call_safe(const std::set<std::string>& services) {
  call_safe_of([&](const std::string& service) { return services.contains(service); });
}

void Host::call_safe_of(const std::function<bool(const std::string& service)>& is_one) {
  std::vector<std::pair<std::string, std::string>> calls;
  {
    const MutexLock lock(mutex_);
    for (const auto& entry : entries_)
      for (const rsm::Operation& operation : entry->model->operations)
        if (operation.safe && is_one(entry->status.key)) calls.emplace_back(entry->status.key, operation.name);
  }
  for (auto& [service, operation] : calls) call({}, service, std::move(operation), {}, {});
}

// The component is told of a call, or of all of the core. It may answer one before it comes to the next.
Host::Work Host::abandoning(ServiceEntry& entry, Caller caller) {
  return [this, &entry, caller = std::move(caller)](Component& component) {
    std::vector<CallId> calls;
    {
      const MutexLock lock(mutex_);
      if (caller.call == 0)
        calls = entry.ledger->abandon_all(caller.core);
      else if (const CallId call = entry.ledger->abandon(caller))
        calls = {call};
    }
    for (const CallId call : calls)
      if (is_pending(entry, call)) component.abandoned(call);
  };
}

bool Host::is_pending(const ServiceEntry& entry, CallId call) const {
  const MutexLock lock(mutex_);
  return entry.ledger->is_pending(call);
}

// Says why not, in the log.
bool Host::can_be_called(const PendingCall& call, ServiceEntry& entry) {
  const std::string& key = entry.status.key;
  if (!entry.status.available) return refuse(call, key, "lost"), false;
  if (!find_operation(*entry.model, call.operation)) return refuse(call, key, "no such operation"), false;
  if (entry.ledger->is_full() && !call.caller.core.empty()) return refuse_more(call, entry), false;
  const std::size_t waiting = entry.ledger->pending().size() + entry.arriving.count();
  if (waiting <= CallLedger::kMostPending / 2) entry.refusal_logged = false;
  return true;
}

// core/SEMANTICS.md, R7. Asked with each call: what is let through has arrived, and what comes later is refused.
std::optional<Value> Host::refuse_motion(const PendingCall& call, const ServiceEntry& entry) {
  const rsm::CallEffect effect = rsm::effect_of(*find_operation(*entry.model, call.operation));
  if (!rsm::moves(effect)) return std::nullopt;
  return gate_.refuse(call.caller, entry.status.key, effect);
}

// Said once, until half of those that wait have gone.
void Host::refuse_more(const PendingCall& call, ServiceEntry& entry) {
  if (std::exchange(entry.refusal_logged, true)) return;
  refuse(call, entry.status.key, "as many calls wait already as may, and more are refused");
}

void Host::refuse(const PendingCall& call, const std::string& key, const std::string& why) {
  observer_.logged(call.time, key, "cannot answer `" + call.operation + "` of core " + call.caller.core + ": " + why);
}

void Host::answer_unavailable(const PendingCall& call, const std::string& key) {
  const Response response = Response::unavailable();
  observer_.delivered({Delivery::Kind::response, call.time, entries_.size(), next_delivery_++, key, call.operation,
                       response.value, response.is_error, call.caller, response.units});
}

void Host::answer(ServiceEntry& entry, CallId call, const Response& response) {
  if (const auto pending = entry.ledger->take(call)) deliver_response(entry, *pending, response);
}

void Host::deliver_response(const ServiceEntry& entry, const PendingCall& call, const Response& response) {
  observer_.delivered({Delivery::Kind::response, clock_.now(), entry.number, next_delivery_++, entry.status.key,
                       call.operation, response.value, response.is_error, call.caller, response.units});
}

// ---- What components announce.

void Host::transition(std::size_t number, std::string_view id, CallId call) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  report(entry, entry.ledger->transition(clock_.now(), id, call));
  entry.status.last = std::string(id);
  notify_status(entry);
}

void Host::respond(std::size_t number, CallId call, const Response& response) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  report(entry, entry.ledger->respond(clock_.now(), call, response.value, response.is_error));
  answer(entry, call, response);
  notify_status(entry);
}

void Host::reject(std::size_t number, CallId call) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  report(entry, entry.ledger->reject(clock_.now(), call));
  answer(entry, call, {Dict{{"code", Value(name(ErrorCode::not_accepted))}}, true});
  notify_status(entry);
}

void Host::event(std::size_t number, std::string_view name, Value data) {
  data.freeze();
  const std::size_t units = data.size_units();
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  const CallLedger::Violations violations = entry.ledger->event(clock_.now(), name, data);
  report(entry, violations);
  if (!violations.empty()) notify_status(entry);
  Delivery delivery;
  delivery.time = clock_.now();
  delivery.service = number;
  delivery.sequence = next_delivery_++;
  delivery.key = entry.status.key;
  delivery.name = std::string(name);
  delivery.data = std::move(data);
  delivery.units = units;
  observer_.delivered(delivery);
}

void Host::log(std::size_t number, const std::string& text) {
  const MutexLock lock(mutex_);
  observer_.logged(clock_.now(), entries_[number]->status.key, text);
}

void Host::log(const ServiceEntry& entry, const CallLedger::Violations& violations) {
  for (const Violation& each : violations)
    observer_.logged(each.time, entry.status.key, each.rule + ": " + each.message + of_call(each.call));
}

// Of what the component has announced itself.
void Host::report(ServiceEntry& entry, const CallLedger::Violations& violations) {
  log(entry, violations);
  for (const Violation& each : violations) post(entry, [each](Component& component) { component.violated(each); });
}

void Host::notify_status(const ServiceEntry& entry) { changed_.insert(entry.number); }

void Host::report_changes() {
  const Time now = clock_.now();
  for (auto next = changed_.begin(); next != changed_.end();) {
    ServiceEntry& entry = *entries_[*next];
    if (now < entry.reported + kStatusPeriod) {
      ++next;
      continue;
    }
    entry.update_status(flows_, now);
    observer_.changed(entry.status);
    entry.reported = now;
    next = changed_.erase(next);
  }
}

// ---- What can be seen from outside.

ServiceEntry* Host::find(std::string_view key) const {
  const MutexLock lock(keys_mutex_);
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? nullptr : found->second;
}

std::vector<ServiceStatus> Host::services() const {
  const MutexLock lock(mutex_);
  std::vector<ServiceStatus> all;
  for (const auto& entry : entries_) {
    if (!entry->ledger) continue;
    entry->update_status(flows_, clock_.now());
    all.push_back(entry->status);
  }
  return all;
}

std::optional<ServiceStatus> Host::service(const std::string& key) const {
  const MutexLock lock(mutex_);
  ServiceEntry* entry = find(key);
  if (!entry || !entry->ledger) return std::nullopt;
  entry->update_status(flows_, clock_.now());
  return entry->status;
}

bool Host::is_held(const std::string& service, std::string_view operation) const {
  const MutexLock lock(mutex_);
  const ServiceEntry* entry = find(service);
  const rsm::Operation* found = entry ? find_operation(*entry->model, operation) : nullptr;
  return found && found->held;
}

Expected<rsm::CallEffect> Host::effect_of(const std::string& service, std::string_view operation) const {
  const MutexLock lock(mutex_);
  const ServiceEntry* entry = find(service);
  if (!entry || !entry->ledger) return unexpected(ErrorCode::not_found, "there is no service of this key", service);
  const rsm::Operation* found = find_operation(*entry->model, operation);
  return found ? rsm::effect_of(*found) : rsm::CallEffect::none;
}

std::map<std::string, rsm::Service> Host::models() const {
  const MutexLock lock(mutex_);
  std::map<std::string, rsm::Service> all;
  for (const auto& entry : entries_)
    if (entry->ledger) all.emplace(entry->status.key, *entry->model);
  return all;
}

}  // namespace race::services
