// What becomes of the components of a host: attached, disconnected, reconnected, stopped; and how they are called.
#include <exception>
#include <tuple>
#include <utility>

#include "services/host/host.h"

namespace race::services {

void Host::attach(const std::string& key, std::unique_ptr<Component> component, Connection connection) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *find(key);
  std::ignore = entry.attach(std::move(component));
  if (connection == Connection::connected) return make_available(entry);
  notify_status(entry);
}

void Host::reconnect(const std::string& key) {
  const MutexLock lock(mutex_);
  ServiceEntry* entry = find(key);
  if (!entry || entry->status.available) return;
  observer_.logged(clock_.now(), key, "available");
  make_available(*entry);
}

void Host::make_available(ServiceEntry& entry) {
  entry.status.available = true;
  entry.status.last.clear();
  notify_status(entry);
  if (speed_limit_) entry.speed_limit_due = true;
  if (entry.speed_limit_due) post_speed_limit(entry);
  for (const std::string& flow : flows_.demanded(entry.status.key)) set_demand(entry.status.key, flow, true);
}

void Host::disconnect(const std::string& key, const std::string& why) {
  const MutexLock lock(mutex_);
  if (ServiceEntry* entry = find(key)) disconnect(*entry, "lost: " + why);
}

void Host::replace(const std::string& key, std::unique_ptr<Component> component, const std::string& why) {
  std::unique_ptr<Component> before;  // ends without the lock
  {
    const MutexLock lock(mutex_);
    ServiceEntry& entry = *find(key);
    disconnect(entry, "begins anew: " + why);
    before = std::exchange(entry.component, std::move(component));
    make_available(entry);
  }
  before->stop();
}

void Host::describe(const std::string& key, std::string type, std::unique_ptr<Component> component) {
  std::unique_ptr<Component> before;  // ends without the lock
  {
    const MutexLock lock(mutex_);
    ServiceEntry& entry = *find(key);
    disconnect(entry, "begins anew: it has another RSM");
    entry.status.type = std::move(type);
    before = entry.attach(std::move(component));
    notify_status(entry);
    observer_.redescribed();
  }
  if (before) before->stop();
}

// `text`: for the log.
void Host::disconnect(ServiceEntry& entry, const std::string& text) {
  if (!entry.status.available) return;
  entry.status.available = false;
  ++entry.disconnections;
  observer_.logged(clock_.now(), entry.status.key, text);
  const Response unavailable = Response::unavailable();
  for (const auto& [id, call] : entry.ledger->reset()) deliver_response(entry, call, unavailable);
  flows_.traffic().reset(entry.status.key);
  notify_status(entry);
  for (const Flows::Subscription& each : flows_.subscriptions_of(entry.number))
    set_subscription(entry, each.key, each.flow, false);
  reservations_.drop(entry.number);
}

void Host::stop() {
  reservations_.close();
  std::size_t number = 0;
  for (Component* component : components()) {
    if (component) component->stop();
    const MutexLock lock(mutex_);
    entries_[number++]->status.available = false;
  }
}

// ---- How components are called.

void Host::post(ServiceEntry& entry, Work work, WorkQueue::Lane lane) {
  auto run_it = [this, number = entry.number, disconnections = entry.disconnections.load(), work = std::move(work)] {
    run(number, disconnections, work);
  };
  entry.queue.post(std::move(run_it), lane);
}

// A component is told of a limit of the speed before anything else. One that throws is disconnected. Work that was
// posted before a disconnection does not reach what reconnects.
void Host::run(std::size_t number, std::optional<std::uint64_t> disconnections, const Work& work) {
  Component* component = nullptr;
  bool speed_limit_due = false;
  std::optional<double> speed_limit;
  {
    const MutexLock lock(mutex_);
    ServiceEntry& entry = *entries_[number];
    if (!entry.status.available || entry.disconnections != disconnections.value_or(entry.disconnections)) return;
    component = entry.component.get();
    speed_limit_due = std::exchange(entry.speed_limit_due, false);
    speed_limit = speed_limit_;
  }
  try {
    if (speed_limit_due) component->limit_speed(speed_limit);
    work(*component);
  } catch (const std::exception& failure) {
    const MutexLock lock(mutex_);
    disconnect(*entries_[number], std::string("lost: ") + failure.what());
  }
}

void Host::limit_speed(std::optional<double> tool_speed) {
  const MutexLock lock(mutex_);
  speed_limit_ = tool_speed;
  for (const auto& entry : entries_) {
    if (!entry->component) continue;
    entry->speed_limit_due = true;
    post_speed_limit(*entry);
  }
}

// With whatever comes next, or else with this.
void Host::post_speed_limit(ServiceEntry& entry) {
  post(entry, [](Component&) {});
}

void Host::step(const WorkQueue& queue) {
  for (const std::size_t number : services_of(queue))
    run(number, std::nullopt, [](Component& component) { component.step(); });
}

void Host::advance(bool wait) {
  for (Reservations::Due& due : reservations_.take(clock_.now(), wait)) {
    const MutexLock lock(mutex_);
    post(*entries_[due.service], [answer = std::move(due.answer)](Component&) { answer(); });
  }
  const MutexLock lock(mutex_);
  for (const std::string& key : flows_.traffic().stopped(clock_.now())) notify_traffic(key);
  report_changes();
}

std::vector<std::size_t> Host::services_of(const WorkQueue& queue) const {
  const MutexLock lock(mutex_);
  std::vector<std::size_t> numbers;
  for (const auto& entry : entries_)
    if (&entry->queue == &queue) numbers.push_back(entry->number);
  return numbers;
}

std::vector<Component*> Host::components() const {
  const MutexLock lock(mutex_);
  std::vector<Component*> all;
  for (const auto& entry : entries_) all.push_back(entry->component.get());
  return all;
}

}  // namespace race::services
