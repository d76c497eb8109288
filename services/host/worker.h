// Worker: a thread for the heavy work of one component, so that its group never waits for it. What the work gives comes
// back to the group at a world time that was reserved when it began (ServiceHost::reserve).
//
// Threads: made, used and destroyed on the component's group; the work runs on the worker's own.
#pragma once

#include <functional>

#include "services/component.h"
#include "services/host/work_queue.h"

namespace race::services {

class Worker {
 public:
  using Answer = std::function<void()>;

  /// `host` outlives the worker.
  explicit Worker(ServiceHost& host) : host_(host) {}

  /// Runs `heavy` on the thread, after what was begun before; the answer it gives runs on the component's group at
  /// `at`. If it throws, the answer throws the same: the component is disconnected.
  void submit(Time at, std::function<Answer()> heavy);

 private:
  ServiceHost& host_;
  WorkThread thread_;
};

}  // namespace race::services
