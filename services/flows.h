// Flows: who listens to which data flow of which service, and the newest packet that waits for each. Mere bookkeeping:
// the Host does what follows from it.
//
// Threads: one at a time, under the host's lock.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "services/component.h"

namespace race::services {

class Flows {
 public:
  using WatchId = std::uint64_t;
  using Watcher = std::function<void(const PacketPtr&)>;

  /// A service that listens, or a watcher outside.
  struct Listener {
    std::string key, flow;    // what is listened to
    std::size_t service = 0;  // number of the listening service
    PacketPtr waiting;        // on its way to it
    WatchId watch = 0;        // 0: a service
    Watcher watcher;
  };

  /// Whether anybody listens to `flow` of the service `key`.
  bool wanted(std::string_view key, std::string_view flow) const;
  /// The flows of the service `key` that somebody listens to, each once.
  std::vector<std::string> wanted_of(std::string_view key) const;

  /// The service number `service` listens from now on, or no longer; nothing changes if that is so already.
  void listen(std::size_t service, std::string_view key, std::string_view flow, bool on);
  WatchId watch(std::string_view key, std::string_view flow, Watcher watcher);
  /// Removes a watch and returns it as it was; no key: there was none.
  Listener unwatch(WatchId id);

  /// Calls the watchers of the flow and returns the services to which the packet is now on its way; those to which an
  /// older one still is get the newer one instead of it and are not named again.
  std::vector<std::size_t> publish(std::string_view key, std::string_view flow, const PacketPtr& packet);
  /// The packet on its way to `service`; none if it has stopped listening.
  PacketPtr take(std::size_t service, std::string_view key, std::string_view flow);
  /// What `service` listens to.
  std::vector<Listener> of(std::size_t service) const;

 private:
  std::vector<Listener> listeners_;  // in order of their coming
  WatchId next_watch_ = 1;
};

}  // namespace race::services
