#include "services/host/host.h"

#include <algorithm>
#include <utility>

#include "services/arguments.h"

namespace race::services {

class Host::Endpoint final : public ServiceHost {
 public:
  Endpoint(Host& host, std::size_t number) : host_(host), number_(number) {}

  Time now() const override { return host_.clock_.now(); }
  void transition(std::string_view id, CallId call) override { host_.transition(number_, id, call); }
  void result(CallId call, Value value) override { host_.respond(number_, call, std::move(value), false); }
  void error(CallId call, Value error) override { host_.respond(number_, call, std::move(error), true); }
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

Host::Host(const Clock& clock, HostObserver& observer) : clock_(clock), observer_(observer) {}
Host::~Host() = default;

ServiceHost& Host::declare(std::string key, std::string type, WorkQueue& queue) {
  const MutexLock lock(mutex_);
  auto entry = std::make_unique<ServiceEntry>(entries_.size(), std::move(key), std::move(type), queue);
  entry->host = std::make_unique<Endpoint>(*this, entry->number);
  entries_.push_back(std::move(entry));
  return *entries_.back()->host;
}

// ---- Calls.

CallId Host::call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs) {
  for (Value& argument : args) argument.freeze();
  kwargs.freeze();
  const MutexLock lock(mutex_);
  const PendingCall pending{next_call_++, operation, clock_.now(), std::move(caller)};
  ServiceEntry* entry = find(service);
  if (!entry || !entry->status.available || !find_operation(entry->model, operation)) {
    answer_unavailable(pending, service, entry);
    return pending.id;
  }
  log(*entry, entry->ledger->call(pending, args, kwargs));
  notify_status(*entry);
  post(*entry, [call = Call{pending.id, std::move(operation), std::move(args), std::move(kwargs)}](
                   Component& component) { component.call(call); });
  return pending.id;
}

void Host::abandon(const Caller& caller) {
  const MutexLock lock(mutex_);
  for (const auto& entry : entries_)
    if (const CallId call = entry->ledger ? entry->ledger->abandon(caller) : 0) tell_abandoned(*entry, call);
}

void Host::abandon_all(const std::string& core) {
  const MutexLock lock(mutex_);
  for (const auto& entry : entries_)
    if (entry->ledger)
      for (const CallId call : entry->ledger->abandon_all(core)) tell_abandoned(*entry, call);
}

// It may answer what was called before it comes to this.
void Host::tell_abandoned(ServiceEntry& entry, CallId call) {
  post(entry, [this, number = entry.number, call](Component& component) {
    if (is_pending(number, call)) component.abandoned(call);
  });
}

bool Host::is_pending(std::size_t number, CallId call) const {
  const MutexLock lock(mutex_);
  return entries_[number]->ledger->is_pending(call);
}

void Host::answer_unavailable(const PendingCall& call, const std::string& key, const ServiceEntry* entry) {
  const std::string why = !entry ? "there is no such service" : entry->status.available ? "no such operation" : "lost";
  Delivery answer{Delivery::Kind::response,
                  call.time,
                  entries_.size(),
                  next_delivery_++,
                  key,
                  call.operation,
                  Dict{{"code", Value(name(ErrorCode::unavailable))}},
                  true,
                  call.caller};
  answer.data.freeze();
  observer_.logged(call.time, key, "cannot answer `" + call.operation + "` of core " + call.caller.core + ": " + why);
  observer_.delivered(answer);
}

void Host::answer(ServiceEntry& entry, CallId call, Value value, bool is_error) {
  if (const auto pending = entry.ledger->take(call)) deliver_response(entry, *pending, std::move(value), is_error);
}

void Host::deliver_response(const ServiceEntry& entry, const PendingCall& call, Value value, bool is_error) {
  Delivery delivery{Delivery::Kind::response, clock_.now(), entry.number, next_delivery_++, entry.status.key,
                    call.operation,           {},           is_error,     call.caller};
  delivery.data = std::move(value.freeze());
  observer_.delivered(delivery);
}

// ---- What components announce.

void Host::transition(std::size_t number, std::string_view id, CallId call) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  log(entry, entry.ledger->transition(clock_.now(), id, call));
  entry.status.last = std::string(id);
  notify_status(entry);
}

void Host::respond(std::size_t number, CallId call, Value value, bool is_error) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  log(entry, entry.ledger->respond(clock_.now(), call, value, is_error));
  answer(entry, call, std::move(value), is_error);
  notify_status(entry);
}

void Host::reject(std::size_t number, CallId call) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  log(entry, entry.ledger->reject(clock_.now(), call));
  answer(entry, call, Dict{{"code", Value(name(ErrorCode::not_accepted))}}, true);
  notify_status(entry);
}

void Host::event(std::size_t number, std::string_view name, Value data) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  const CallLedger::Violations violations = entry.ledger->event(clock_.now(), name, data);
  log(entry, violations);
  if (!violations.empty()) notify_status(entry);
  Delivery delivery;
  delivery.time = clock_.now();
  delivery.service = number;
  delivery.sequence = next_delivery_++;
  delivery.key = entry.status.key;
  delivery.name = std::string(name);
  delivery.data = std::move(data.freeze());
  observer_.delivered(delivery);
}

void Host::log(std::size_t number, const std::string& text) {
  const MutexLock lock(mutex_);
  observer_.logged(clock_.now(), entries_[number]->status.key, text);
}

void Host::log(const ServiceEntry& entry, const CallLedger::Violations& violations) {
  for (const Violation& each : violations)
    observer_.logged(each.time, entry.status.key, each.rule + ": " + each.message);
}

void Host::notify_status(ServiceEntry& entry) {
  entry.update_status(flows_, clock_.now());
  observer_.changed(entry.status);
}

// ---- What can be seen from outside.

ServiceEntry* Host::find(const std::string& key) const {
  const auto found = std::ranges::find_if(entries_, [&](const auto& each) { return each->status.key == key; });
  return found == entries_.end() ? nullptr : found->get();
}

std::vector<ServiceStatus> Host::services() const {
  const MutexLock lock(mutex_);
  std::vector<ServiceStatus> all;
  for (const auto& entry : entries_) {
    entry->update_status(flows_, clock_.now());
    all.push_back(entry->status);
  }
  return all;
}

std::optional<ServiceStatus> Host::service(const std::string& key) const {
  const MutexLock lock(mutex_);
  ServiceEntry* entry = find(key);
  if (!entry) return std::nullopt;
  entry->update_status(flows_, clock_.now());
  return entry->status;
}

std::map<std::string, rsm::Service> Host::models() const {
  const MutexLock lock(mutex_);
  std::map<std::string, rsm::Service> all;
  for (const auto& entry : entries_) all.emplace(entry->status.key, entry->model);
  return all;
}

}  // namespace race::services
