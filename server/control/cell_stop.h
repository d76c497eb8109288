// CellStop: what happens when somebody stops the cell, or resets it: the latch at once, then every safe operation, then
// the end of all runs.
//
// Threads: any. stop() waits for nothing but the locks of the control and the host, which nobody holds for long; what
// takes longer is done on a thread of its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "server/control/control.h"
#include "server/control/stop_mark.h"
#include "server/execution/cores.h"
#include "server/threads/strand.h"
#include "services/host/host.h"

namespace race::server {

class CellStop {
 public:
  using Log = std::function<void(const std::string& text)>;
  /// All outlive this. A cell that was stopped when the last server ended is stopped again.
  CellStop(Control& control, services::Host& host, Cores& cores, StopMark mark, Log log);

  /// `by`: who stops it, as people read it; `now`: ms since 1970.
  void stop(const std::string& by, std::int64_t now);
  /// Motions may begin again, when a person begins one.
  void reset(const std::string& by);
  /// Nothing is done any more that is not begun.
  void end() { pool_.end(); }

 private:
  void follow(const std::string& text);
  void end_runs();

  Control& control_;
  services::Host& host_;
  Cores& cores_;
  const StopMark mark_;
  const Log log_;
  std::atomic<std::int64_t> called_{0};  // when the safe operations were called last [ms since 1970]
  Pool pool_{1, 0, "stops"};
};

}  // namespace race::server
