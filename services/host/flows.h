// Flows: who listens to which data flow of which service, the newest packet that waits for each, and what has passed
// lately. Mere bookkeeping: the Host does what follows from it.
//
// Threads: one at a time, under the host's lock.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "services/component.h"

namespace race::services {

/// A data flow that a service offers, and what passes on it.
struct Published {
  struct Last {
    Time time = 0;
    Value header;
  };
  std::string flow;
  std::size_t watchers = 0;  // from outside; services that listen say so themselves
  double rate_hz = 0;        // packets in a second of the host's clock; 0: none pass
  std::optional<Last> last;  // since somebody listens
};

/// A data flow that a service reads, and whether it listens now.
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

  /// A service that listens, or a watcher outside.
  struct Subscription {
    std::string key, flow;    // what is listened to
    std::size_t service = 0;  // number of the listening service
    PacketPtr waiting;        // on its way to it
    WatchId watch = 0;        // 0: a service
    Watcher watcher;
  };

  /// Whether anybody listens to `flow` of the service `key`.
  bool has_demand(std::string_view key, std::string_view flow) const;
  /// Whether the service number `service` listens to it.
  bool is_subscribed(std::size_t service, std::string_view key, std::string_view flow) const;
  /// The flows of the service `key` that somebody listens to, each once.
  std::vector<std::string> demanded(std::string_view key) const;

  /// The service number `service` listens from now on, or no longer; nothing changes if that is so already.
  void set_subscription(std::size_t service, std::string_view key, std::string_view flow, bool on);
  WatchId watch(std::string_view key, std::string_view flow, Watcher watcher);
  /// Removes a watch and returns it as it was; no key: there was none.
  Subscription unwatch(WatchId id);

  /// Calls the watchers of the flow and returns the services to which the packet is now on its way; those to which an
  /// older one still is get the newer one instead of it and are not named again.
  std::vector<std::size_t> publish(std::string_view key, std::string_view flow, const PacketPtr& packet);
  /// The packet on its way to `service`; none if it has stopped listening.
  PacketPtr take(std::size_t service, std::string_view key, std::string_view flow);

  /// Counts a packet of a flow that is wanted. Whether what traffic() says now is worth telling: at first, then once a
  /// second.
  bool record(std::string_view key, std::string_view flow, const Packet& packet, Time now);
  /// What passes on a flow; one that has been silent for much longer than its period has stopped.
  Published traffic(std::string_view key, std::string_view flow, Time now) const;
  /// The services of flows that have stopped since it was asked last: what was reported of these is not so any more.
  std::vector<std::string> stopped(Time now);
  /// The service `key` is gone: nothing passes on its flows.
  void reset(std::string_view key);
  /// What `service` listens to.
  std::vector<Subscription> subscriptions_of(std::size_t service) const;

 private:
  static constexpr std::size_t kCounted = 10;

  /// Packets of a flow since it is wanted.
  struct Traffic {
    Time period() const;  // 0: of too few
    bool has_stopped(Time now) const;
    std::string key, flow;
    std::deque<Time> times;  // of the last kCounted since it stopped, as of the host's clock
    Published::Last last;
    Time reported = 0;
  };
  void drop_undemanded();

  std::vector<Subscription> subscriptions_;  // in order of their coming
  std::vector<Traffic> traffic_;
  WatchId next_watch_ = 1;
};

}  // namespace race::services
