#include "services/host.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "core/rsm/monitor.h"
#include "services/arguments.h"

namespace race::services {

// One service: what its component talks to, and what the host knows of it. All fields but the component belong to the
// host's lock.
struct Host::Slot final : ServiceHost {
  Slot(Host& its_host, std::size_t its_number, std::string its_key, std::string its_type, WorkQueue& its_unit)
      : host(its_host), number(its_number), unit(its_unit) {
    status.key = std::move(its_key);
    status.type = std::move(its_type);
  }

  Time now() const override { return host.clock_.now(); }

  void transition(std::string_view id, CallId call) override {
    const std::lock_guard lock(host.mutex_);
    if (!status.available) return;
    record(monitor->transition(id, call));
    status.last = std::string(id);
    drop_superseded();
    changed();
  }

  void result(CallId call, Value value) override { respond(call, std::move(value), false); }
  void error(CallId call, Value error) override { respond(call, std::move(error), true); }

  void reject(CallId call) override {
    const std::lock_guard lock(host.mutex_);
    if (!status.available) return;
    record(monitor->rejected(call));
    answer(call, Value(Dict{{"code", Value(name(ErrorCode::not_accepted))}}), true);
    changed();
  }

  void event(std::string_view name, Value data) override {
    const std::lock_guard lock(host.mutex_);
    if (!status.available) return;
    if (record(monitor->event(name, data))) changed();
    Delivery delivery;
    delivery.time = host.clock_.now();
    delivery.service = number;
    delivery.sequence = host.next_delivery_++;
    delivery.key = status.key;
    delivery.name = std::string(name);
    delivery.data = std::move(data.freeze());
    host.observer_.delivered(delivery);
  }

  void publish(std::string_view flow, PacketPtr packet) override {
    const std::lock_guard lock(host.mutex_);
    if (status.available) host.publish(*this, flow, packet);
  }

  void subscribe(std::string_view key, std::string_view flow, bool on) override {
    const std::lock_guard lock(host.mutex_);
    if (!status.available) return;
    const rsm::Uses used{std::string(key), std::string(flow)};
    if (std::ranges::find(model.subscribes, used) != model.subscribes.end()) return host.listen(*this, key, flow, on);
    record({{"subscribes", "`" + used.service + "." + used.name + "` is not declared", 0}});
    changed();
  }

  ReservationId reserve(Time at) override { return host.reservations_.reserve(number, at); }
  void fulfil(ReservationId reservation, std::function<void()> answer) override {
    host.reservations_.fulfil(reservation, std::move(answer));
  }

  void log(std::string text) override {
    const std::lock_guard lock(host.mutex_);
    host.observer_.logged(host.clock_.now(), status.key, text);
  }

  // The functions below need the host's lock.

  void respond(CallId call, Value value, bool is_error) {
    const std::lock_guard lock(host.mutex_);
    if (!status.available) return;
    record(is_error ? monitor->error(call, value) : monitor->result(call, value));
    answer(call, std::move(value), is_error);
    changed();
  }

  /// The response goes to its caller if the call still waits: once.
  void answer(CallId call, Value value, bool is_error) {
    const auto waits = std::find_if(status.pending.begin(), status.pending.end(),
                                    [&](const PendingCall& pending) { return pending.id == call; });
    if (waits == status.pending.end()) return;
    const PendingCall pending = std::move(*waits);
    status.pending.erase(waits);
    host.deliver_response(*this, pending, std::move(value), is_error);
  }

  /// Calls that a later one has superseded (R17) get no response any more.
  void drop_superseded() {
    const auto open = monitor->open_calls();
    std::erase_if(status.pending, [&](const PendingCall& pending) {
      return std::find(open.begin(), open.end(), pending.id) == open.end();
    });
  }

  bool record(const rsm::Monitor::Violations& violations) {
    for (const rsm::Violation& violation : violations) {
      std::string operation;
      for (const PendingCall& pending : status.pending)
        if (pending.id == violation.call) operation = pending.operation;
      status.violations.push_back(
          {host.clock_.now(), violation.rule, violation.message, violation.call, std::move(operation)});
      host.observer_.logged(host.clock_.now(), status.key, violation.rule + ": " + violation.message);
    }
    if (status.violations.size() > kViolationsKept)
      status.violations.erase(status.violations.begin(), status.violations.end() - kViolationsKept);
    return !violations.empty();
  }

  void changed() {
    if (!model.is_interface()) status.state = monitor->current();
    look_at_flows();
    host.observer_.changed(status);
  }

  void look_at_flows() {
    for (Published& each : status.publishes) each = host.flows_.traffic(status.key, each.flow, host.clock_.now());
    for (Subscribed& each : status.subscribes) each.listening = host.flows_.listens(number, each.service, each.flow);
  }

  Host& host;
  std::size_t number;
  WorkQueue& unit;
  rsm::Service model;
  std::unique_ptr<Component> component;
  std::unique_ptr<rsm::Monitor> monitor;
  ServiceStatus status;
  std::atomic<std::uint64_t> life = 0;  // how often it was lost
};

namespace {

/// A description is read on several threads: what it holds is frozen, in all copies.
void freeze(rsm::Service& service) {
  for (rsm::Operation& operation : service.operations) {
    operation.result.freeze();
    operation.error.freeze();
    for (rsm::OperationParameter& parameter : operation.parameters) {
      parameter.type.freeze();
      if (parameter.value) parameter.value->freeze();
    }
  }
  for (rsm::Event& event : service.events) event.data.freeze();
  service.meta.freeze();
}

}  // namespace

bool before(const Delivery& a, const Delivery& b) {
  return std::tie(a.time, a.service, a.sequence) < std::tie(b.time, b.service, b.sequence);
}

Host::Host(const Clock& clock, HostObserver& observer) : clock_(clock), observer_(observer) {}
Host::~Host() = default;

ServiceHost& Host::declare(std::string key, std::string type, WorkQueue& unit) {
  const std::lock_guard lock(mutex_);
  slots_.push_back(std::make_unique<Slot>(*this, slots_.size(), std::move(key), std::move(type), unit));
  slots_.back()->status.available = false;
  return *slots_.back();
}

void Host::attach(const std::string& key, std::unique_ptr<Component> component, Presence presence) {
  const std::lock_guard lock(mutex_);
  Slot& slot = *find(key);
  slot.model = component->model();
  freeze(slot.model);
  slot.monitor = std::make_unique<rsm::Monitor>(slot.model);
  slot.component = std::move(component);
  slot.status.model = &slot.model;
  for (std::string& flow : offered(slot.model)) slot.status.publishes.push_back({std::move(flow), 0, 0, {}});
  for (const rsm::Uses& used : slot.model.subscribes)
    slot.status.subscribes.push_back({used.service, used.name, false});
  if (presence == Presence::here) return begin(slot);
  slot.changed();
}

void Host::regain(const std::string& key) {
  const std::lock_guard lock(mutex_);
  Slot* slot = find(key);
  if (!slot || slot->status.available) return;
  observer_.logged(clock_.now(), key, "available");
  begin(*slot);
}

Host::Slot* Host::find(const std::string& key) const {
  for (const auto& slot : slots_)
    if (slot->status.key == key) return slot.get();
  return nullptr;
}

void Host::deliver_response(const Slot& slot, const PendingCall& call, Value value, bool is_error) {
  Delivery delivery{Delivery::Kind::response, clock_.now(), slot.number, next_delivery_++, slot.status.key,
                    call.operation,           {},           is_error,    call.caller};
  delivery.data = std::move(value.freeze());
  observer_.delivered(delivery);
}

CallId Host::call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs) {
  for (Value& argument : args) argument.freeze();
  kwargs.freeze();
  const std::lock_guard lock(mutex_);
  const PendingCall pending{next_call_++, operation, clock_.now(), std::move(caller)};
  Slot* slot = find(service);
  if (!slot || !slot->status.available || !find_operation(slot->model, operation)) {
    Delivery answer{Delivery::Kind::response,
                    pending.time,
                    slots_.size(),
                    next_delivery_++,
                    service,
                    operation,
                    {},
                    true,
                    pending.caller};
    answer.data = Dict{{"code", Value(name(ErrorCode::unavailable))}};
    answer.data.freeze();
    observer_.logged(pending.time, service,
                     "cannot answer `" + operation + "` of core " + pending.caller.core +
                         (!slot                    ? ": there is no such service"
                          : slot->status.available ? ": no such operation"
                                                   : ": lost"));
    observer_.delivered(answer);
    return pending.id;
  }
  slot->status.pending.push_back(pending);
  slot->record(slot->monitor->called(pending.id, operation, args, kwargs));
  slot->changed();
  post(*slot, [call = Call{pending.id, std::move(operation), std::move(args), std::move(kwargs)}](
                  Component& component) { component.call(call); });
  return pending.id;
}

void Host::advance(bool wait) {
  for (Reservations::Due& due : reservations_.take(clock_.now(), wait)) {
    const std::lock_guard lock(mutex_);
    post(*slots_[due.service], [answer = std::move(due.answer)](Component&) { answer(); });
  }
  const std::lock_guard lock(mutex_);
  for (const std::string& key : flows_.stopped(clock_.now())) tell(key);
}

void Host::step(const WorkQueue& unit) {
  for (const auto& slot : slots_)
    if (&slot->unit == &unit && slot->component)
      guarded(*slot, slot->life, [](Component& component) { component.step(); });
}

// A component that throws is as good as dead. What was meant for one that is gone does not reach its successor.
void Host::guarded(Slot& slot, std::uint64_t life, const std::function<void(Component&)>& work) {
  {
    const std::lock_guard lock(mutex_);
    if (!slot.status.available || slot.life != life) return;
  }
  try {
    work(*slot.component);
  } catch (const std::exception& failure) {
    lose(slot, failure.what());
  }
}

void Host::lose(const std::string& key, const std::string& why) {
  if (Slot* slot = find(key)) lose(*slot, why);
}

void Host::lose(Slot& slot, const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (!slot.status.available) return;
  slot.status.available = false;
  ++slot.life;
  observer_.logged(clock_.now(), slot.status.key, "lost: " + why);
  Value unavailable = Dict{{"code", Value(name(ErrorCode::unavailable))}};
  unavailable.freeze();
  for (const PendingCall& pending : slot.status.pending) deliver_response(slot, pending, unavailable, true);
  slot.status.pending.clear();
  slot.monitor->restarted();
  flows_.fall_silent(slot.status.key);
  slot.changed();
  for (const Flows::Listener& each : flows_.of(slot.number)) listen(slot, each.key, each.flow, false);
  reservations_.drop(slot.number);
}

Flows::WatchId Host::watch(const std::string& service, const std::string& flow, Flows::Watcher watcher) {
  const std::lock_guard lock(mutex_);
  const bool before = flows_.wanted(service, flow);
  const Flows::WatchId id = flows_.watch(service, flow, std::move(watcher));
  if (!before) want(service, flow, true);
  tell(service);
  return id;
}

void Host::unwatch(Flows::WatchId watch) {
  const std::lock_guard lock(mutex_);
  const Flows::Listener gone = flows_.unwatch(watch);
  if (gone.watch == 0) return;
  if (!flows_.wanted(gone.key, gone.flow)) want(gone.key, gone.flow, false);
  tell(gone.key);
}

// The functions below need the host's lock.

void Host::begin(Slot& slot) {
  slot.status.available = true;
  slot.status.last.clear();
  slot.changed();
  for (const std::string& flow : flows_.wanted_of(slot.status.key)) want(slot.status.key, flow, true);
}

void Host::post(Slot& slot, std::function<void(Component&)> work) {
  slot.unit.post([this, &slot, life = slot.life.load(), work = std::move(work)] { guarded(slot, life, work); });
}

void Host::listen(Slot& slot, std::string_view key, std::string_view flow, bool on) {
  const bool before = flows_.wanted(key, flow);
  flows_.listen(slot.number, key, flow, on);
  if (flows_.wanted(key, flow) != before) want(key, std::string(flow), on);
  tell(key);
  slot.changed();
}

// What passes on the flows of a service, if there is one of this key by now, has changed.
void Host::tell(std::string_view key) {
  Slot* slot = find(std::string(key));
  if (slot && slot->component) slot->changed();
}

// Tells the publisher, if there is one by now, that somebody listens or nobody does.
void Host::want(std::string_view key, const std::string& flow, bool on) {
  Slot* publisher = find(std::string(key));
  if (!publisher || !publisher->status.available) return;
  post(*publisher, [flow, on](Component& component) { component.wanted(flow, on); });
}

void Host::publish(Slot& slot, std::string_view flow, const PacketPtr& packet) {
  if (!flows_.wanted(slot.status.key, flow)) return;
  if (flows_.count(slot.status.key, flow, *packet, clock_.now())) slot.changed();
  for (const std::size_t number : flows_.publish(slot.status.key, flow, packet)) {
    Slot* to = slots_[number].get();
    post(*to, [this, to, key = slot.status.key, flow = std::string(flow)](Component& component) {
      PacketPtr newest;
      {
        const std::lock_guard lock(mutex_);
        newest = flows_.take(to->number, key, flow);
      }
      if (newest) component.packet(key, flow, newest);
    });
  }
}

void Host::stop() {
  reservations_.close();
  for (const auto& slot : slots_) {
    if (slot->component) slot->component->stop();
    const std::lock_guard lock(mutex_);
    slot->status.available = false;
  }
}

std::vector<ServiceStatus> Host::services() const {
  const std::lock_guard lock(mutex_);
  std::vector<ServiceStatus> all;
  for (const auto& slot : slots_) {
    slot->look_at_flows();
    all.push_back(slot->status);
  }
  return all;
}

std::optional<ServiceStatus> Host::service(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  Slot* slot = find(key);
  if (!slot) return std::nullopt;
  slot->look_at_flows();
  return slot->status;
}

std::map<std::string, rsm::Service> Host::models() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, rsm::Service> all;
  for (const auto& slot : slots_) all.emplace(slot->status.key, slot->model);
  return all;
}

}  // namespace race::services
