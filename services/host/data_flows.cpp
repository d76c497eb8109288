// The data flows of a host: packets from service to service and to watchers outside, past the cores.
#include <utility>

#include "services/host/host.h"

namespace race::services {

Flows::WatchId Host::watch(const std::string& service, const std::string& flow, Flows::Watcher watcher) {
  const MutexLock lock(mutex_);
  const bool before = flows_.has_demand(service, flow);
  const Flows::WatchId id = flows_.watch(service, flow, std::move(watcher));
  if (!before) set_demand(service, flow, true);
  notify_traffic(service);
  return id;
}

Flows::WatchId Host::overhear(const std::string& service, const std::string& flow, Flows::Watcher watcher) {
  const MutexLock lock(mutex_);
  return flows_.overhear(service, flow, std::move(watcher));
}

void Host::unwatch(Flows::WatchId watch) {
  const MutexLock lock(mutex_);
  const Flows::Subscription removed = flows_.unwatch(watch);
  if (removed.watch == 0 || !removed.is_wanted) return;
  if (!flows_.has_demand(removed.key, removed.flow)) set_demand(removed.key, removed.flow, false);
  notify_traffic(removed.key);
}

void Host::subscribe(std::size_t number, std::string_view key, std::string_view flow, bool on) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  if (!entry.status.available) return;
  if (entry.declares_subscription(key, flow)) return set_subscription(entry, key, flow, on);
  const std::string name = std::string(key) + "." + std::string(flow);
  report(entry, entry.ledger->add(clock_.now(), {{"subscribes", "`" + name + "` is not declared", 0}}));
  notify_status(entry);
}

void Host::set_subscription(ServiceEntry& entry, std::string_view key, std::string_view flow, bool on) {
  const bool before = flows_.has_demand(key, flow);
  flows_.set_subscription(entry.number, key, flow, on);
  if (flows_.has_demand(key, flow) != before) set_demand(std::string(key), std::string(flow), on);
  notify_traffic(std::string(key));
  notify_status(entry);
}

// Tells the publisher, if there is one by now, that somebody subscribes to its flow or nobody does.
void Host::set_demand(const std::string& key, const std::string& flow, bool on) {
  ServiceEntry* publisher = find(key);
  if (!publisher || !publisher->status.available) return;
  post(*publisher, [flow, on](Component& component) { component.demand_changed(flow, on); });
}

// The traffic on the flows of a service, if there is one of this key by now, has changed.
void Host::notify_traffic(const std::string& key) {
  ServiceEntry* entry = find(key);
  if (entry && entry->component) notify_status(*entry);
}

void Host::publish(std::size_t number, std::string_view flow, const PacketPtr& packet) {
  const MutexLock lock(mutex_);
  ServiceEntry& entry = *entries_[number];
  const std::string& key = entry.status.key;
  if (!entry.status.available || !flows_.has_demand(key, flow)) return;
  if (flows_.traffic().record(key, flow, *packet, clock_.now())) notify_status(entry);
  for (const std::size_t to : flows_.publish(key, flow, packet))
    post(*entries_[to],
         [this, to, key, flow = std::string(flow)](Component& component) { deliver_packet(to, key, flow, component); });
}

void Host::deliver_packet(std::size_t number, const std::string& key, const std::string& flow, Component& component) {
  PacketPtr newest;
  {
    const MutexLock lock(mutex_);
    newest = flows_.take(number, key, flow);
  }
  if (newest) component.packet(key, flow, newest);
}

}  // namespace race::services
