// Host: hosts components and stands between them and the cores. It gives calls their ids and hands them to the group of
// their service; follows what each service announces with a monitor (R18) and records what does not fit; keeps the
// calls that wait for a response, and answers those that nobody will (`unavailable`, R7). What services say leaves it
// as Deliveries through the observer: events to everyone, a response to the caller alone. Packets of data flows go from
// service to service, past the cores (flows.h); answers that are due hold world time up (reservations.h).
//
// Threads: call(), watch() and the queries on any. A component is called on its group's thread. The observer and the
// watchers of flows are called under the host's lock, in the order in which things happened: they must be quick and
// must not call the host.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/rsm/model.h"
#include "services/clock.h"
#include "services/component.h"
#include "services/host/flows.h"
#include "services/host/reservations.h"
#include "services/host/work_queue.h"

namespace race::services {

/// Who called: a core and its number of the call; no core: the server.
struct Caller {
  std::string core;
  std::uint64_t call = 0;
  bool operator==(const Caller&) const = default;
};

/// What a service says to cores.
struct Delivery {
  enum class Kind { event, response } kind = Kind::event;
  Time time = 0;
  std::size_t service = 0;     // number of the service in order of declaration
  std::uint64_t sequence = 0;  // counts deliveries of the host
  std::string key, name;       // of the service; of the event or the operation
  Value data;                  // frozen
  bool is_error = false;       // of a response
  Caller caller;               // of a response
};

/// The order in which deliveries reach cores: (time, service, sequence).
bool before(const Delivery& a, const Delivery& b);

struct PendingCall {
  CallId id = 0;
  std::string operation;
  Time time = 0;  // when it arrived
  Caller caller;
};

/// What did not fit: the rule of the RSM, why, in which call (0: none).
struct Violation {
  Time time = 0;
  std::string rule, message;
  CallId call = 0;
  std::string operation;
};

/// What can be seen of a service from outside.
struct ServiceStatus {
  std::string key, type;
  const rsm::Service* model = nullptr;  // lives as long as the host
  std::optional<std::string> state;     // none: a mere interface
  bool available = true;
  std::vector<PendingCall> pending;   // in order of call
  std::vector<Violation> violations;  // the last kViolationsKept
  std::string last;                   // id of the transition taken last; empty: none yet
  std::vector<Published> publishes;   // as of now
  std::vector<Subscribed> subscribes;
};

class HostObserver {
 public:
  virtual ~HostObserver() = default;
  virtual void delivered(const Delivery& delivery) = 0;
  /// State, pending calls, violations or flows of a service have changed; of a flow that passes, once a second.
  virtual void changed(const ServiceStatus& status) = 0;
  virtual void logged(Time time, const std::string& key, const std::string& text) = 0;
};

class Host {
 public:
  static constexpr std::size_t kViolationsKept = 100;

  /// Both live longer than the host.
  Host(const Clock& clock, HostObserver& observer);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Declares a service before anything is called: its key (after `svc.`), its type and the group it lives in, which
  /// outlives the calls. The component is made with what this returns and handed to attach().
  ServiceHost& declare(std::string key, std::string type, WorkQueue& queue);
  /// `awaited`: what does the component's work is not there yet; its service is lost until reconnect().
  enum class Connection { connected, disconnected };
  void attach(const std::string& key, std::unique_ptr<Component> component,
              Connection connection = Connection::connected);

  /// Calls an operation. Its response reaches the observer once, now or later, with `caller`; an unknown or lost
  /// service or an unknown operation answers {"code": "unavailable"}. `args` and `kwargs` are frozen here.
  CallId call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs);

  /// Time has passed: the answers that are due now go to their groups. With `wait`, those that are due and not there
  /// yet are waited for. Observers hear of flows that have stopped. On the thread that sets the clock, after it was
  /// set.
  void advance(bool wait);
  /// step() of each component of `queue`, in order of declaration. On the group's thread.
  void step(const WorkQueue& queue);
  /// The component is gone (died, hangs, was unplugged): its pending calls are answered `unavailable` in order of call,
  /// and it says nothing any more. Nothing that was on its way to it reaches it, also after reconnect(). `why`: for the
  /// log.
  void disconnect(const std::string& key, const std::string& why = "unplugged");
  /// What was lost is there again, in the initial state of its RSM.
  void reconnect(const std::string& key);
  /// stop() of all components: groups have ended, or are those of this thread. Nothing is called afterwards.
  void stop();

  /// Watches a data flow from outside, until unwatch(): nothing is called once that has returned.
  Flows::WatchId watch(const std::string& service, const std::string& flow, Flows::Watcher watcher);
  void unwatch(Flows::WatchId watch);

  std::vector<ServiceStatus> services() const;
  std::optional<ServiceStatus> service(const std::string& key) const;
  /// Key -> description, as a Program wants it.
  std::map<std::string, rsm::Service> models() const;

 private:
  struct ServiceEntry;
  friend struct ServiceEntry;

  ServiceEntry* find(const std::string& key) const;
  void deliver_response(const ServiceEntry& entry, const PendingCall& call, Value value, bool is_error);
  void post(ServiceEntry& entry, std::function<void(Component&)> work);
  void run_guarded(ServiceEntry& entry, std::uint64_t connection_count, const std::function<void(Component&)>& work);
  void disconnect(ServiceEntry& entry, const std::string& why);
  void make_available(ServiceEntry& entry);
  void set_subscription(ServiceEntry& entry, std::string_view key, std::string_view flow, bool on);
  void notify_status(std::string_view key);
  void publish(ServiceEntry& entry, std::string_view flow, const PacketPtr& packet);
  void set_demand(std::string_view key, const std::string& flow, bool on);

  const Clock& clock_;
  HostObserver& observer_;
  mutable std::mutex mutex_;
  Flows flows_;
  Reservations reservations_;                           // outlives the components: their threads fulfil
  std::vector<std::unique_ptr<ServiceEntry>> entries_;  // in order of declaration; fixed after the start
  CallId next_call_ = 1;
  std::uint64_t next_delivery_ = 1;
};

}  // namespace race::services
