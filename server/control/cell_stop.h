// CellStop: what follows in the cell when somebody stops it, or resets it, or the permission of what moves ends: the
// latch at once, then the safe operations, then runs.
//
// Threads: any. Waits for nothing but the locks of the control and the host, which nobody holds for long; runs are
// ended on a thread of its own, and on another one the marks are written, so that no run waits for the disk.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "core/value/expected.h"
#include "server/control/control.h"
#include "server/control/mode_mark.h"
#include "server/control/stop_mark.h"
#include "server/execution/cores.h"
#include "server/threads/strand.h"
#include "services/host/host.h"
#include "services/mutex.h"

namespace race::server {

class CellStop {
 public:
  using Log = std::function<void(const std::string& text)>;
  /// What outlives the server.
  struct Marks {
    StopMark stop;
    ModeMark mode;
  };
  /// All outlive this. A cell that was stopped when the last server ended is stopped again, and its mode is as it was.
  CellStop(Control& control, services::Host& host, Cores& cores, Marks marks, Log log);

  /// `by`: who stops it, as people read it; `now`: ms since 1970. Whether it was not stopped before.
  bool stop(const std::string& by, std::int64_t now);
  /// Motions may begin again, when a person begins one. Whether it was stopped: else nothing is done.
  bool reset(const std::string& by);
  /// What moved by a permission that has ended stops: its runs take nothing more that comes, then the safe operations
  /// of its services are called. The runs are paused, and go on when a person wants that. `why`: for the log, if
  /// anything stops.
  void halt(const Control::Ended& ended, const std::string& why);
  /// The control has another mode, the robots its limit of speed, and the file its mark: one change after the other, so
  /// that the three never tell of two modes. What moved before stops. Error `leased`: `number` has not the controls.
  Expected<void> set_mode(std::uint64_t number, Mode mode) EXCLUDES(modes_mutex_);
  /// Does what is still to be done, and nothing any more.
  void end();

 private:
  void limit_speed(Mode mode);
  void write_stop();
  void write_mode();
  void end_runs();

  Control& control_;
  services::Host& host_;
  Cores& cores_;
  const Marks marks_;
  const Log log_;
  services::Mutex modes_mutex_;                             // the control's and the host's may be taken under it
  std::atomic<bool> mode_waits_{false};                     // to be written
  std::atomic<Control::Steady> called_{Control::Steady()};  // when the safe operations were called last
  Pool pool_{1, 0, "stops"}, disk_{1, 0, "marks"};
};

}  // namespace race::server
