// Remotes: the services of a server whose components live in other processes, and which of these processes are
// connected (process_link.h). A service of these is `unavailable` until its process connects, and again when that is
// disconnected: its connection ends, or it answers no ping for the time of the heartbeat. A process that reconnects
// starts in the initial state of its RSM.
//
// Threads: each group has a thread of its own, on which everything that its process says reaches the host, in order,
// and what the host says leaves for the process; all services of own_services.h are one group. ProcessLinks are on the
// sockets' thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/host/host.h"
#include "services/host/work_queue.h"
#include "services/mutex.h"
#include "services/remote/host_functions.h"
#include "services/remote/own_services.h"
#include "services/remote/remote_component.h"
#include "services/remote/remote_world.h"

namespace race::remote {

/// A service as the server expects it of a process.
struct RemoteService {
  std::string key, type;
  const rsm::Service* model = nullptr;  // outlives all
  HostFunctions host_functions = {};
};

class Remotes {
 public:
  /// `heartbeat` > 0. Both outlive it.
  Remotes(services::Host& host, const services::Clock& clock, std::chrono::milliseconds heartbeat);
  ~Remotes();

  /// Declares the group `name`: services that one process brings together, and the world that it may bring with them,
  /// which outlives this. Before anything is called.
  void add(std::string name, const std::vector<RemoteService>& services, RemoteWorld* world = nullptr) EXCLUDES(mutex_);
  /// The group kOwnGroup: services of which the server knows beforehand that processes will bring them, and all others
  /// that processes bring of themselves, which may have any key that the host does not know. `accounts`: the only ones
  /// that may bring any (beside who is of no account); nothing: all of the group. Once, before anything is called.
  void add_own(const std::vector<RemoteService>& expected, std::optional<std::set<std::string>> accounts)
      EXCLUDES(mutex_);
  /// Sends `news` to processes where something has changed for their host functions. By one thread.
  void step() EXCLUDES(mutex_);
  /// The threads of the groups end: what was said so far is still done. Links may remain and do nothing any more.
  void stop() EXCLUDES(mutex_);

  std::chrono::milliseconds heartbeat() const { return heartbeat_; }

 private:
  friend class ProcessLink;

  /// One service; fixed after the start.
  struct Place {
    RemoteService service;
    std::size_t group = 0;
    RemoteComponent* component = nullptr;  // the host's
  };
  /// Who a process is.
  struct Owner {
    std::vector<std::string> groups;  // that it may bring
    std::string account;              // empty: none, but a process of the server's own user
  };
  /// What a process has claimed.
  struct Claim {
    std::size_t group = 0;
    std::vector<std::string> keys;        // of all, in the order of its hello
    std::vector<const Place*> places;     // of those that the server has declared
    std::vector<Offer> offers;            // the others
    RemoteWorld* remote_world = nullptr;  // none: it brought no world
    RemoteWorld::World world;
  };

  std::size_t make_group(std::string name, RemoteWorld* world) REQUIRES(mutex_);
  void declare(std::size_t group, const std::vector<RemoteService>& services) REQUIRES(mutex_);
  Expected<Claim> find(const Value& components) const;
  Expected<std::size_t> find(const std::string& key, const std::string& type, const Value& rsm, Claim& claim) const;
  Expected<void> check_rights(const Claim& claim, const Owner& owner) const;
  Expected<Claim> claim(const Value& components, const Value& world, const Owner& owner) EXCLUDES(mutex_);
  void release(const std::vector<std::string>& keys, const RemoteWorld* world) EXCLUDES(mutex_);
  void post(std::size_t group, services::WorkQueue::Work work) EXCLUDES(mutex_);

  services::Host& host_;
  const services::Clock& clock_;
  const std::chrono::milliseconds heartbeat_;
  std::map<std::string, Place> places_;            // by key; fixed after the start
  std::vector<std::string> names_;                 // of the groups; fixed after the start
  std::vector<RemoteWorld*> worlds_;               // of each group, or none; fixed after the start
  std::map<std::string, std::uint64_t> versions_;  // of host functions in the last step()
  std::size_t own_group_ = 0;                      // of own_; fixed after the start, as the next two
  std::optional<std::set<std::string>> own_accounts_;
  std::unique_ptr<OwnServices> own_;  // none: processes bring declared services alone. Its add() under the lock
  services::Mutex mutex_;
  std::vector<std::unique_ptr<services::WorkThread>> groups_ GUARDED_BY(mutex_);
  std::set<std::string> claimed_ GUARDED_BY(mutex_);  // keys, by processes
  std::set<const RemoteWorld*> claimed_worlds_ GUARDED_BY(mutex_);
};

}  // namespace race::remote
