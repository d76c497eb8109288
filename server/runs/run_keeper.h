// RunKeeper: what is done beside the runs of a server: samples of the cell are stored while they are running, and when
// one is over or was imported, the store is brought within its limits.
//
// Threads: any, after connect(); the work is done on a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/value/value.h"
#include "server/cell/cell_world.h"
#include "server/execution/cores.h"
#include "server/log/line_log.h"
#include "server/store/retention.h"
#include "server/store/runs.h"
#include "server/store/samples.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class RunKeeper {
 public:
  static constexpr double kInterval = 0.2;     // [s] of world time between samples, until they are thinned out
  static constexpr std::size_t kWritten = 25;  // samples of a run that are written at once

  static constexpr std::size_t kMostWaiting = 100;  // poses, while the disk takes nothing; then some are left out

  using Log = std::function<void(LogLevel, const std::string&)>;
  /// All outlive it; `log` is called on its thread.
  RunKeeper(Runs& runs, Samples& samples, const RetentionLimits& limits, Log log)
      : runs_(runs), samples_(samples), limits_(limits), log_(std::move(log)) {}
  /// Writes what is left.
  ~RunKeeper();

  /// To be called once, before the first core is created. Both outlive it; `world` may be null.
  void connect(const Cores& cores, CellWorld* world);
  /// A core has changed (schemas/core.json), or was removed (null).
  void core_changed(const std::string& id, const Value& core) EXCLUDES(mutex_);
  /// The cell is so now (schemas/cell_pose.json, frozen). On one thread.
  void record(const Value& pose);
  /// Brings the store within its limits.
  void apply_limits();
  /// Returns when the samples until now are written and no run is being removed. Not on its thread.
  void flush();

 private:
  // On its thread.
  void take(const Value& pose);
  void write(RunId run);
  void write_all();

  Runs& runs_;
  Samples& samples_;
  const RetentionLimits limits_;
  const Log log_;
  const Cores* cores_ = nullptr;
  CellWorld* world_ = nullptr;

  services::Mutex mutex_;
  std::set<std::string> running_ GUARDED_BY(mutex_);  // cores
  std::atomic<std::size_t> poses_{0};                 // that wait to be taken
  std::atomic<bool> limits_due_{false};               // they will be applied
  double due_ = 0;                                    // [s] of world time: of the thread of record()
  std::map<RunId, std::vector<Sample>> waiting_;      // of the thread of the pool
  Pool pool_{1, 0, "runs"};
  Strand strand_{pool_};
};

}  // namespace race::server
