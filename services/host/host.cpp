#include "services/host/host.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "core/rsm/monitor.h"
#include "services/arguments.h"

namespace race::services {

// One service: what its component talks to, and what the host knows of it. All fields but the component belong to the
// host's lock.
struct Host::ServiceEntry final : ServiceHost {
  ServiceEntry(Host& its_host, std::size_t its_number, std::string its_key, std::string its_type, WorkQueue& its_queue)
      : host(its_host), number(its_number), queue(its_queue) {
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
    if (std::ranges::find(model.subscribes, used) != model.subscribes.end())
      return host.set_subscription(*this, key, flow, on);
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
    update_flows();
    host.observer_.changed(status);
  }

  void update_flows() {
    for (Published& each : status.publishes) each = host.flows_.traffic(status.key, each.flow, host.clock_.now());
    for (Subscribed& each : status.subscribes)
      each.listening = host.flows_.is_subscribed(number, each.service, each.flow);
  }

  Host& host;
  std::size_t number;
  WorkQueue& queue;
  rsm::Service model;
  std::unique_ptr<Component> component;
  std::unique_ptr<rsm::Monitor> monitor;
  ServiceStatus status;
  std::atomic<std::uint64_t> connection_count = 0;  // how often it was lost
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

ServiceHost& Host::declare(std::string key, std::string type, WorkQueue& queue) {
  const std::lock_guard lock(mutex_);
  entries_.push_back(std::make_unique<ServiceEntry>(*this, entries_.size(), std::move(key), std::move(type), queue));
  entries_.back()->status.available = false;
  return *entries_.back();
}

void Host::attach(const std::string& key, std::unique_ptr<Component> component, Connection connection) {
  const std::lock_guard lock(mutex_);
  ServiceEntry& entry = *find(key);
  entry.model = component->model();
  freeze(entry.model);
  entry.monitor = std::make_unique<rsm::Monitor>(entry.model);
  entry.component = std::move(component);
  entry.status.model = &entry.model;
  for (std::string& flow : offered(entry.model)) entry.status.publishes.push_back({std::move(flow), 0, 0, {}});
  for (const rsm::Uses& used : entry.model.subscribes)
    entry.status.subscribes.push_back({used.service, used.name, false});
  if (connection == Connection::connected) return make_available(entry);
  entry.changed();
}

void Host::reconnect(const std::string& key) {
  const std::lock_guard lock(mutex_);
  ServiceEntry* entry = find(key);
  if (!entry || entry->status.available) return;
  observer_.logged(clock_.now(), key, "available");
  make_available(*entry);
}

Host::ServiceEntry* Host::find(const std::string& key) const {
  for (const auto& entry : entries_)
    if (entry->status.key == key) return entry.get();
  return nullptr;
}

void Host::deliver_response(const ServiceEntry& entry, const PendingCall& call, Value value, bool is_error) {
  Delivery delivery{Delivery::Kind::response, clock_.now(), entry.number, next_delivery_++, entry.status.key,
                    call.operation,           {},           is_error,     call.caller};
  delivery.data = std::move(value.freeze());
  observer_.delivered(delivery);
}

CallId Host::call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs) {
  for (Value& argument : args) argument.freeze();
  kwargs.freeze();
  const std::lock_guard lock(mutex_);
  const PendingCall pending{next_call_++, operation, clock_.now(), std::move(caller)};
  ServiceEntry* entry = find(service);
  if (!entry || !entry->status.available || !find_operation(entry->model, operation)) {
    Delivery answer{Delivery::Kind::response,
                    pending.time,
                    entries_.size(),
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
                         (!entry                    ? ": there is no such service"
                          : entry->status.available ? ": no such operation"
                                                    : ": lost"));
    observer_.delivered(answer);
    return pending.id;
  }
  entry->status.pending.push_back(pending);
  entry->record(entry->monitor->called(pending.id, operation, args, kwargs));
  entry->changed();
  post(*entry, [call = Call{pending.id, std::move(operation), std::move(args), std::move(kwargs)}](
                   Component& component) { component.call(call); });
  return pending.id;
}

void Host::advance(bool wait) {
  for (Reservations::Due& due : reservations_.take(clock_.now(), wait)) {
    const std::lock_guard lock(mutex_);
    post(*entries_[due.service], [answer = std::move(due.answer)](Component&) { answer(); });
  }
  const std::lock_guard lock(mutex_);
  for (const std::string& key : flows_.stopped(clock_.now())) notify_status(key);
}

void Host::step(const WorkQueue& queue) {
  for (const auto& entry : entries_)
    if (&entry->queue == &queue && entry->component)
      run_guarded(*entry, entry->connection_count, [](Component& component) { component.step(); });
}

// A component that throws is as good as dead. What was meant for one that is removed does not reach its successor.
void Host::run_guarded(ServiceEntry& entry, std::uint64_t connection_count,
                       const std::function<void(Component&)>& work) {
  {
    const std::lock_guard lock(mutex_);
    if (!entry.status.available || entry.connection_count != connection_count) return;
  }
  try {
    work(*entry.component);
  } catch (const std::exception& failure) {
    disconnect(entry, failure.what());
  }
}

void Host::disconnect(const std::string& key, const std::string& why) {
  if (ServiceEntry* entry = find(key)) disconnect(*entry, why);
}

void Host::disconnect(ServiceEntry& entry, const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (!entry.status.available) return;
  entry.status.available = false;
  ++entry.connection_count;
  observer_.logged(clock_.now(), entry.status.key, "lost: " + why);
  Value unavailable = Dict{{"code", Value(name(ErrorCode::unavailable))}};
  unavailable.freeze();
  for (const PendingCall& pending : entry.status.pending) deliver_response(entry, pending, unavailable, true);
  entry.status.pending.clear();
  entry.monitor->restarted();
  flows_.reset(entry.status.key);
  entry.changed();
  for (const Flows::Subscription& each : flows_.subscriptions_of(entry.number))
    set_subscription(entry, each.key, each.flow, false);
  reservations_.drop(entry.number);
}

Flows::WatchId Host::watch(const std::string& service, const std::string& flow, Flows::Watcher watcher) {
  const std::lock_guard lock(mutex_);
  const bool before = flows_.has_demand(service, flow);
  const Flows::WatchId id = flows_.watch(service, flow, std::move(watcher));
  if (!before) set_demand(service, flow, true);
  notify_status(service);
  return id;
}

void Host::unwatch(Flows::WatchId watch) {
  const std::lock_guard lock(mutex_);
  const Flows::Subscription removed = flows_.unwatch(watch);
  if (removed.watch == 0) return;
  if (!flows_.has_demand(removed.key, removed.flow)) set_demand(removed.key, removed.flow, false);
  notify_status(removed.key);
}

// The functions below need the host's lock.

void Host::make_available(ServiceEntry& entry) {
  entry.status.available = true;
  entry.status.last.clear();
  entry.changed();
  for (const std::string& flow : flows_.demanded(entry.status.key)) set_demand(entry.status.key, flow, true);
}

void Host::post(ServiceEntry& entry, std::function<void(Component&)> work) {
  entry.queue.post([this, &entry, connection_count = entry.connection_count.load(), work = std::move(work)] {
    run_guarded(entry, connection_count, work);
  });
}

void Host::set_subscription(ServiceEntry& entry, std::string_view key, std::string_view flow, bool on) {
  const bool before = flows_.has_demand(key, flow);
  flows_.set_subscription(entry.number, key, flow, on);
  if (flows_.has_demand(key, flow) != before) set_demand(key, std::string(flow), on);
  notify_status(key);
  entry.changed();
}

// What passes on the flows of a service, if there is one of this key by now, has changed.
void Host::notify_status(std::string_view key) {
  ServiceEntry* entry = find(std::string(key));
  if (entry && entry->component) entry->changed();
}

// Tells the publisher, if there is one by now, that somebody listens or nobody does.
void Host::set_demand(std::string_view key, const std::string& flow, bool on) {
  ServiceEntry* publisher = find(std::string(key));
  if (!publisher || !publisher->status.available) return;
  post(*publisher, [flow, on](Component& component) { component.demand_changed(flow, on); });
}

void Host::publish(ServiceEntry& entry, std::string_view flow, const PacketPtr& packet) {
  if (!flows_.has_demand(entry.status.key, flow)) return;
  if (flows_.record(entry.status.key, flow, *packet, clock_.now())) entry.changed();
  for (const std::size_t number : flows_.publish(entry.status.key, flow, packet)) {
    ServiceEntry* to = entries_[number].get();
    post(*to, [this, to, key = entry.status.key, flow = std::string(flow)](Component& component) {
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
  for (const auto& entry : entries_) {
    if (entry->component) entry->component->stop();
    const std::lock_guard lock(mutex_);
    entry->status.available = false;
  }
}

std::vector<ServiceStatus> Host::services() const {
  const std::lock_guard lock(mutex_);
  std::vector<ServiceStatus> all;
  for (const auto& entry : entries_) {
    entry->update_flows();
    all.push_back(entry->status);
  }
  return all;
}

std::optional<ServiceStatus> Host::service(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  ServiceEntry* entry = find(key);
  if (!entry) return std::nullopt;
  entry->update_flows();
  return entry->status;
}

std::map<std::string, rsm::Service> Host::models() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, rsm::Service> all;
  for (const auto& entry : entries_) all.emplace(entry->status.key, entry->model);
  return all;
}

}  // namespace race::services
