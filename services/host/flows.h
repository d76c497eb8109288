// Flows: who subscribes to which data flow of which service, the newest packet that waits for each subscriber, and the
// traffic. Bookkeeping alone: the Host acts on it.
//
// Threads: one at a time, under the host's lock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "services/component.h"
#include "services/host/flow_traffic.h"

namespace race::services {

/// A data flow that a service reads, and whether it subscribes to it now.
struct Subscribed {
  std::string service, flow;
  bool listening = false;
};

/// The flows that a service says it offers: the names in `flows` of its RSM's meta.
std::vector<std::string> offered(const rsm::Service& model);

class Flows {
 public:
  using WatchId = std::uint64_t;
  using Watcher = std::function<void(const PacketPtr&)>;

  /// Of a service, or of a watcher outside.
  struct Subscription {
    std::string key, flow;    // what is subscribed to
    std::size_t service = 0;  // number of the subscriber
    PacketPtr waiting;        // on its way to it
    WatchId watch = 0;        // 0: a service
    bool is_wanted = true;    // false: what passes because of others is enough
    Watcher watcher;
  };

  /// Whether `flow` of the service `key` has a subscriber.
  bool has_demand(std::string_view key, std::string_view flow) const;
  /// Whether the service number `service` subscribes to it.
  bool is_subscribed(std::size_t service, std::string_view key, std::string_view flow) const;
  /// The flows of the service `key` that have subscribers, each once.
  std::vector<std::string> demanded(std::string_view key) const;
  /// Those of the service number `service`.
  std::vector<Subscription> subscriptions_of(std::size_t service) const;

  /// The service number `service` subscribes from now on, or no longer; nothing changes if that is so already.
  void set_subscription(std::size_t service, std::string_view key, std::string_view flow, bool on);
  WatchId watch(std::string_view key, std::string_view flow, Watcher watcher);
  /// As watch(), but is no subscriber: the watcher gets what passes because of others.
  WatchId overhear(std::string_view key, std::string_view flow, Watcher watcher);
  /// Removes a watch and returns it as it was; `watch` is 0: there was none.
  Subscription unwatch(WatchId id);

  /// Calls the watchers of the flow and returns the services to which the packet is now on its way; those to which an
  /// older one still is get the newer one instead of it and are not named again.
  std::vector<std::size_t> publish(std::string_view key, std::string_view flow, const PacketPtr& packet);
  /// The packet on its way to `service`; none if it has unsubscribed.
  PacketPtr take(std::size_t service, std::string_view key, std::string_view flow);

  /// What passes on flows that have subscribers.
  FlowTraffic& traffic() { return traffic_; }
  /// What passes on a flow now, and how many watch it.
  Published published(std::string_view key, std::string_view flow, Time now) const;

 private:
  WatchId add(Subscription watch);

  std::vector<Subscription> subscriptions_;  // the oldest first
  FlowTraffic traffic_;
  WatchId next_watch_ = 1;
};

}  // namespace race::services
