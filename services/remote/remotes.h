// Remotes: the services of a server whose components live in other processes, and who has come for them. A service of
// these is `unavailable` until its process is there, and again when that is lost: its connection ends, or it answers no
// ping for the time of the heartbeat. What comes back starts in the initial state of its RSM.
//
// Threads: ProcessLink's functions on the sockets' thread. Each group has a thread of its own, on which everything that
// a process says reaches the host, in order, and what the host says leaves for the process.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/host/host.h"
#include "services/host/work_queue.h"
#include "services/remote/host_functions.h"
#include "services/remote/protocol.h"
#include "services/remote/remote_component.h"
#include "services/remote/remote_world.h"
#include "services/remote/send_queue.h"

namespace race::remote {

/// A service as the server expects it of a process.
struct RemoteService {
  std::string key, type;
  const rsm::Service* model = nullptr;  // outlives all
  HostFunctions host_functions = {};
};

class Remotes;

/// The server's end of one connection: what a process says, and how long it has been silent. Held by its socket.
class ProcessLink {
 public:
  static constexpr int kPingsPerHeartbeat = 4;  // pings in the time of the heartbeat

  explicit ProcessLink(Remotes& remotes);
  ~ProcessLink();
  ProcessLink(const ProcessLink&) = delete;
  ProcessLink& operator=(const ProcessLink&) = delete;

  /// What waits to be sent; the connection is to end once that is drained.
  SendQueue& out();
  /// A message came. What does not fit is answered `refused`, and the process is lost.
  void received(EncodedMessage frame);
  /// To be called kPingsPerHeartbeat times in the time of the heartbeat: sends a ping; loses a process that has
  /// answered none of the last kPingsPerHeartbeat.
  void check_heartbeat();
  /// The connection has ended: the process is lost, because of `why`.
  void disconnect(const std::string& why);
  /// Whether it is lost or was refused.
  bool disconnected() const { return disconnected_; }

 private:
  struct Process;

  Expected<void> accept_hello(const EncodedMessage& frame);

  Remotes& remotes_;
  std::shared_ptr<Process> process_;  // with work on its way to the group
  bool accepted_ = false, disconnected_ = false;
  int unanswered_ = 0;  // beats since the last pong
  std::int64_t pings_ = 0;
};

class Remotes {
 public:
  /// `heartbeat` > 0. Both outlive it.
  Remotes(services::Host& host, const services::Clock& clock, std::chrono::milliseconds heartbeat);
  ~Remotes();

  /// Declares services that one process brings together, and the world that it may bring with them, which outlives
  /// this. Before anything is called.
  void add(const std::vector<RemoteService>& services, RemoteWorld* world = nullptr);
  /// Tells processes what is new at their desks. By one thread.
  void step();
  /// The groups end: what was said so far is still done. Links may remain and do nothing any more.
  void stop();

  std::chrono::milliseconds heartbeat() const { return heartbeat_; }

 private:
  friend class ProcessLink;

  struct Place {
    RemoteService service;
    std::size_t group = 0;
    RemoteComponent* component = nullptr;  // the host's
    bool taken = false;                    // by a process
    std::uint64_t seen = 0;                // the version of its functions in the last step()
  };
  struct WorldPlace {
    RemoteWorld* world = nullptr;  // none: its process has none
    bool taken = false;
  };

  struct Claim {
    std::vector<Place*> places;
    RemoteWorld* end = nullptr;  // of the world that was brought
    RemoteWorld::World world;
  };

  Expected<std::vector<Place*>> find(const Value& components);
  Expected<Claim> claim(const Value& components, const Value& world);
  void release(const std::vector<std::string>& keys, const RemoteWorld* world);
  void post(std::size_t group, services::WorkQueue::Work work);

  services::Host& host_;
  const services::Clock& clock_;
  const std::chrono::milliseconds heartbeat_;
  std::mutex mutex_;
  std::map<std::string, Place> places_;  // by key; fixed after the start but for `taken` and `seen`
  std::vector<std::unique_ptr<services::WorkThread>> groups_;  // empty after stop()
  std::vector<WorldPlace> worlds_;                             // of the groups; fixed after the start but for `taken`
};

}  // namespace race::remote
