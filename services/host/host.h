// Host: hosts components and connects them to the cores. It gives calls their ids and hands them to the queue of their
// service; where that is run they arrive, and it holds them and what each service announces against its RSM
// (call_ledger.h), and answers calls that no component will answer (`unavailable`, R7). What services say leaves it as
// Deliveries through the observer: events to all cores, a response to the caller alone. Packets of data flows go from
// service to service, past the cores (flows.h); answers that are due hold world time up (reservations.h).
//
// What a call, an announcement or a packet costs does not depend on how many calls wait: what can be seen of a service
// is put together in advance(), and told at most once in kStatusPeriod. A service has a bounded number of calls that
// wait (CallLedger::kMostPending), and as many that are on their way; more are answered `unavailable`.
//
// Who calls takes no lock that a component or an observer needs: cores that make thousands of calls hold up nobody.
//
// Threads: call(), watch() and the queries on any. A component is called on the thread of its queue. The observer and
// the watchers of flows are called under the host's lock, in the order in which things happened: they must be quick and
// must not call the host.
//
// host.cpp has calls and announcements, lifecycle.cpp what becomes of components, data_flows.cpp packets.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/rsm/call_effect.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "services/clock.h"
#include "services/component.h"
#include "services/host/delivery.h"
#include "services/host/flows.h"
#include "services/host/motion_gate.h"
#include "services/host/reservations.h"
#include "services/host/service_entry.h"
#include "services/host/work_queue.h"
#include "services/mutex.h"

namespace race::services {

class HostObserver {
 public:
  virtual ~HostObserver() = default;
  virtual void delivered(const Delivery& delivery) = 0;
  /// State, pending calls, violations or flows of a service have changed; of a flow that passes, once a second. What
  /// changes within Host::kStatusPeriod is told at once, at its end.
  virtual void changed(const ServiceStatus& status) = 0;
  /// Since the start, a service has come that was not there, or one has another RSM.
  virtual void redescribed() {}
  virtual void logged(Time time, const std::string& key, const std::string& text) = 0;
};

class Host {
 public:
  static constexpr Time kStatusPeriod = 0.02;  // [s]

  /// All live longer than the host. `gate`: what lets calls set the cell in motion; nullptr: all may.
  Host(const Clock& clock, HostObserver& observer, MotionGate* gate = nullptr);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Declares a service before anything is called: its key (after `svc.`), its type and the queue where its component
  /// runs, which outlives the calls. The component is made with what this returns and handed to attach().
  ServiceHost& declare(std::string key, std::string type, WorkQueue& queue) EXCLUDES(mutex_);
  /// `disconnected`: the process of the component is not there yet; the service is not available until reconnect().
  enum class Connection { connected, disconnected };
  void attach(const std::string& key, std::unique_ptr<Component> component,
              Connection connection = Connection::connected) EXCLUDES(mutex_);

  /// Calls an operation. Its response reaches the observer once, now or later, with `caller`; an unknown or
  /// disconnected service, an unknown operation or a service for which too many wait answers {"code": "unavailable"}.
  /// It arrives, and can be seen, when the queue of the service is run. `args` and `kwargs` are frozen here. It comes
  /// after the calls that the core of its caller has made before or, of a caller without one, those of `after`; without
  /// either, before all that wait. The calls of a caller without a core are few, and no number of others keeps them
  /// out. One that `moves` is answered by the gate unless that lets it pass. `supersedes`: the number of the earlier
  /// call of the same core and operation to whose place it comes: that is abandoned first; 0: none.
  CallId call(Caller caller, const std::string& service, std::string operation, List args, Dict kwargs,
              const std::string& after = {}, std::uint64_t supersedes = 0) EXCLUDES(mutex_, keys_mutex_);

  /// Nobody can receive the response to the call that `caller` made, or to any call of `core` whose response is still
  /// to come: the component is told, once (Component::abandoned). Nothing else happens, and nothing at all to a call
  /// that has had its response. It comes after what that core has called before.
  void abandon(const Caller& caller) EXCLUDES(mutex_);
  void abandon_all(const std::string& core) EXCLUDES(mutex_);

  /// Calls each operation of each service that is `safe`, before all that wait; nobody gets the responses.
  void call_safe() EXCLUDES(mutex_, keys_mutex_);
  /// The same of these services alone.
  void call_safe(const std::set<std::string>& services) EXCLUDES(mutex_, keys_mutex_);
  /// No component moves its tool faster than this [m/s, finite, at least 0; nothing: no limit], from now until it is
  /// called again. Each component is told before all that waits for it (Component::limit_speed), the newest limit
  /// alone; one that is attached, reconnects or takes another's place later, before anything else is called on it. On
  /// any thread.
  void limit_speed(std::optional<double> tool_speed) EXCLUDES(mutex_);
  MotionGate& gate() const { return gate_; }

  /// Time has passed: the answers that are due now go to their queues. With `wait`, those that are due and not there
  /// yet are waited for. Observers hear of services that have changed. On the thread that sets the clock, after it was
  /// set.
  void advance(bool wait) EXCLUDES(mutex_);
  /// step() of each component of `queue`, in order of declaration. On the thread of the queue.
  void step(const WorkQueue& queue) EXCLUDES(mutex_);
  /// The component has died, hangs or was unplugged: its pending calls are answered `unavailable` in order of call, and
  /// it says nothing any more. Nothing that was on its way to it reaches it, also after reconnect(). `why`: for the
  /// log.
  void disconnect(const std::string& key, const std::string& why = "unplugged") EXCLUDES(mutex_);
  /// The component is there again, in the initial state of its RSM.
  void reconnect(const std::string& key) EXCLUDES(mutex_);
  /// Another component of the same model takes the place of the one that is there, in the initial state of its RSM. For
  /// calls and what was on its way, that is disconnect() and reconnect(). On the thread of the queue.
  void replace(const std::string& key, std::unique_ptr<Component> component, const std::string& why) EXCLUDES(mutex_);
  /// While everything runs: the component of a service that was just declared, or another one, of another type or
  /// model, of a service that is there. It is disconnected; of one that was there, nothing is left. On the thread of
  /// the queue.
  void describe(const std::string& key, std::string type, std::unique_ptr<Component> component) EXCLUDES(mutex_);
  /// stop() of all components: queues are run no longer, or are those of this thread. Nothing is called afterwards.
  void stop() EXCLUDES(mutex_);

  /// Watches a data flow from outside, until unwatch(): nothing is called once that has returned.
  Flows::WatchId watch(const std::string& service, const std::string& flow, Flows::Watcher watcher) EXCLUDES(mutex_);
  /// The same of what passes because of others: nobody publishes for this watcher.
  Flows::WatchId overhear(const std::string& service, const std::string& flow, Flows::Watcher watcher) EXCLUDES(mutex_);
  void unwatch(Flows::WatchId watch) EXCLUDES(mutex_);

  /// Whether there is a service of this key.
  bool has(std::string_view key) const EXCLUDES(keys_mutex_) { return find(key) != nullptr; }
  std::vector<ServiceStatus> services() const EXCLUDES(mutex_);
  std::optional<ServiceStatus> service(const std::string& key) const EXCLUDES(mutex_);
  /// Whether the service has such an operation, which is called while a person holds a button (rsm::Operation::held).
  bool is_held(const std::string& service, std::string_view operation) const EXCLUDES(mutex_);
  /// Of a call of the operation, by its marks; `none`: the service has no such operation. Error `not_found`: there is
  /// no such service.
  Expected<rsm::CallEffect> effect_of(const std::string& service, std::string_view operation) const EXCLUDES(mutex_);
  /// Key -> description, as a Program reads it.
  std::map<std::string, rsm::Service> models() const EXCLUDES(mutex_);

 private:
  class Endpoint;  // the ServiceHost of a component: hands its announcements to the functions below
  using Work = std::function<void(Component&)>;

  /// Frozen and counted before the lock is taken: it may be large.
  struct Response {
    Response(Value its_value, bool error)
        : value(std::move(its_value.freeze())), units(value.size_units()), is_error(error) {}
    static Response unavailable();
    Value value;
    std::size_t units;
    bool is_error;
  };

  // What the component of the service `number` announces; nothing happens while it is disconnected.
  void transition(std::size_t number, std::string_view id, CallId call) EXCLUDES(mutex_);
  void respond(std::size_t number, CallId call, const Response& response) EXCLUDES(mutex_);
  void reject(std::size_t number, CallId call) EXCLUDES(mutex_);
  void event(std::size_t number, std::string_view name, Value data) EXCLUDES(mutex_);
  void publish(std::size_t number, std::string_view flow, const PacketPtr& packet) EXCLUDES(mutex_);
  void subscribe(std::size_t number, std::string_view key, std::string_view flow, bool on) EXCLUDES(mutex_);
  void log(std::size_t number, const std::string& text) EXCLUDES(mutex_);

  // Calls and what is said of them.
  ServiceEntry* find(std::string_view key) const EXCLUDES(keys_mutex_);
  void log(const ServiceEntry& entry, const CallLedger::Violations& violations) REQUIRES(mutex_);
  void report(ServiceEntry& entry, const CallLedger::Violations& violations) REQUIRES(mutex_);
  void notify_status(const ServiceEntry& entry) REQUIRES(mutex_);
  void report_changes() REQUIRES(mutex_);
  void arrive(ServiceEntry& entry, std::uint64_t disconnections, const PendingCall& pending, const Call& call)
      EXCLUDES(mutex_);
  bool accept(ServiceEntry& entry, std::uint64_t disconnections, const PendingCall& pending, const Call& call)
      EXCLUDES(mutex_);
  Work abandoning(ServiceEntry& entry, Caller caller);
  bool is_pending(const ServiceEntry& entry, CallId call) const EXCLUDES(mutex_);
  void call_safe_of(const std::function<bool(const std::string& service)>& is_one) EXCLUDES(mutex_, keys_mutex_);
  void answer(ServiceEntry& entry, CallId call, const Response& response) REQUIRES(mutex_);
  void deliver_response(const ServiceEntry& entry, const PendingCall& call, const Response& response) REQUIRES(mutex_);
  bool can_be_called(const PendingCall& call, ServiceEntry& entry) REQUIRES(mutex_);
  std::optional<Value> refuse_motion(const PendingCall& call, const ServiceEntry& entry) REQUIRES(mutex_);
  void refuse(const PendingCall& call, const std::string& key, const std::string& why) REQUIRES(mutex_);
  void refuse_more(const PendingCall& call, ServiceEntry& entry) REQUIRES(mutex_);
  void answer_unavailable(const PendingCall& call, const std::string& key) REQUIRES(mutex_);

  // What becomes of components.
  void make_available(ServiceEntry& entry) REQUIRES(mutex_);
  void post_speed_limit(ServiceEntry& entry) REQUIRES(mutex_);
  void disconnect(ServiceEntry& entry, const std::string& text) REQUIRES(mutex_);
  void post(ServiceEntry& entry, Work work, WorkQueue::Lane lane = WorkQueue::kNoLane);
  void run(std::size_t number, std::optional<std::uint64_t> disconnections, const Work& work) EXCLUDES(mutex_);
  std::vector<std::size_t> services_of(const WorkQueue& queue) const EXCLUDES(mutex_);
  std::vector<Component*> components() const EXCLUDES(mutex_);

  // Data flows.
  void set_subscription(ServiceEntry& entry, std::string_view key, std::string_view flow, bool on) REQUIRES(mutex_);
  void set_demand(const std::string& key, const std::string& flow, bool on) REQUIRES(mutex_);
  void notify_traffic(const std::string& key) REQUIRES(mutex_);
  void deliver_packet(std::size_t number, const std::string& key, const std::string& flow, Component& component)
      EXCLUDES(mutex_);

  const Clock& clock_;
  HostObserver& observer_;
  OpenGate open_gate_;
  MotionGate& gate_;
  mutable Mutex mutex_;
  Flows flows_ GUARDED_BY(mutex_);
  Reservations reservations_;  // outlives the components: their threads fulfil
  std::vector<std::unique_ptr<ServiceEntry>> entries_ GUARDED_BY(mutex_);  // in order of declaration
  mutable Mutex keys_mutex_;                                               // may be taken under mutex_
  std::map<std::string, ServiceEntry*, std::less<>> by_key_ GUARDED_BY(keys_mutex_);
  std::set<std::size_t> changed_ GUARDED_BY(mutex_);      // numbers of services: the observer is to be told
  std::optional<double> speed_limit_ GUARDED_BY(mutex_);  // m/s
  std::atomic<CallId> next_call_{1};
  std::uint64_t next_delivery_ GUARDED_BY(mutex_) = 1;
};

}  // namespace race::services
