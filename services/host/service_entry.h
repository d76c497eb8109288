// ServiceEntry: what a host knows of one service: its component, where that runs, its calls, and what can be seen of it
// from outside.
//
// Threads: one at a time, under the host's lock, but where it says `any`; the component itself is called on the thread
// of its queue.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/rsm/model.h"
#include "services/component.h"
#include "services/host/arriving_calls.h"
#include "services/host/call_ledger.h"
#include "services/host/flows.h"
#include "services/host/work_queue.h"

namespace race::services {

/// What can be seen of a service from outside.
struct ServiceStatus {
  static constexpr std::size_t kPendingShown = 32;
  std::string key, type;
  std::shared_ptr<const rsm::Service> model;  // held by whoever looks, as the service may get another one
  std::optional<std::string> state;           // none: a mere interface
  bool available = false;
  std::size_t pending_count = 0;      // calls that wait for a response
  std::vector<PendingCall> pending;   // the first kPendingShown of them, in order of call
  CallLedger::Violations violations;  // the last CallLedger::kViolationsKept
  std::string last;                   // id of the transition taken last; empty: none yet
  std::vector<Published> publishes;   // as of now
  std::vector<Subscribed> subscribes;
};

struct ServiceEntry {
  ServiceEntry(std::size_t its_number, std::string key, std::string type, WorkQueue& its_queue);

  /// The component is there, and disconnected. Copies and freezes its model: it is read on several threads. Of another
  /// component, and what was known of its calls, nothing is left: it is returned.
  std::unique_ptr<Component> attach(std::unique_ptr<Component> its_component);
  /// Whether the component may subscribe to this flow.
  bool declares_subscription(std::string_view key, std::string_view flow) const;
  /// Brings `status` up to date; that of a service without a component stays as it is.
  void update_status(const Flows& flows, Time now);

  const std::size_t number;           // in order of declaration
  WorkQueue& queue;                   // where the component runs
  std::unique_ptr<ServiceHost> host;  // what the component talks to
  std::shared_ptr<const rsm::Service> model = std::make_shared<rsm::Service>();
  std::unique_ptr<CallLedger> ledger;  // none: there is no component yet
  ServiceStatus status;
  std::atomic<std::uint64_t> disconnections{0};  // work that was posted before one is dropped; read by any thread
  ArrivingCalls arriving;                        // of any thread
  Time reported = -std::numeric_limits<Time>::infinity();  // when the observer was last told of its status
  bool refusal_logged = false;                             // that so many calls wait that more are refused
  bool speed_limit_due = false;                            // the component has not been told of it (Host::limit_speed)
  std::unique_ptr<Component> component;
};

}  // namespace race::services
