// TimingRecorder: notes when what happens in a run of a core, for its blocks of times (store/timing.h). It keeps beside
// each input that waits in the execution when it came; the execution knows no time.
//
// Threads: service_changed() and what is const on any, the rest on the core's strand.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/execution/execution.h"
#include "server/store/timing.h"
#include "services/mutex.h"

namespace race::server {

class TimingRecorder {
 public:
  using Clock = std::chrono::steady_clock;
  /// A block is due after this time, or with so much in it.
  static constexpr std::chrono::seconds kInterval{5};
  static constexpr std::size_t kSteps = 1024, kChanges = 1024;

  /// Of a run that was made `age_ms` ago, and has so many macro steps: if any, it is rebuilt next.
  explicit TimingRecorder(std::int64_t age_ms, std::uint64_t steps = 0);

  /// An input has come at `time`, and waits in `execution` as the last one.
  void arrived(const execution::Execution& execution, Clock::time_point time) EXCLUDES(mutex_);
  /// A macro step has begun at `time`, perhaps with the first of those that wait: `entry`, if that is known.
  void began(const execution::Execution& execution, const std::optional<execution::JournalEntry>& entry,
             Clock::time_point time) EXCLUDES(mutex_);
  /// Whether it was told that this macro step has begun.
  bool has_begun(std::uint64_t position) const EXCLUDES(mutex_);
  /// The run is over: what waits is dropped.
  void ended(const execution::Execution& execution) EXCLUDES(mutex_);
  /// The run is what its journal says: macro steps after `execution` and what waited have not been.
  void rebuilt(const execution::Execution& execution) EXCLUDES(mutex_);

  /// Of which services changes are noted, with the states that they have.
  void use(const std::vector<ServiceChange>& services) EXCLUDES(mutex_);
  /// Whether it is one of these, and its state is another one.
  bool service_changed(const std::string& service, const std::optional<std::string>& state) EXCLUDES(mutex_);

  /// Something is noted that is in no block yet.
  bool has_news() const EXCLUDES(mutex_);
  bool is_due() const EXCLUDES(mutex_);
  /// A block of what was noted since the last one, which is written with the record `ticket` of the journal, or (0)
  /// when all records are written.
  TimingBlock take_block(const execution::Execution& execution, std::uint64_t ticket) EXCLUDES(mutex_);
  /// What was written with records up to `ticket` is in the store.
  void durable(std::uint64_t ticket) EXCLUDES(mutex_);

  /// What is not in the store yet, as if it were written now, with what waits now as undelivered. To be read before the
  /// store is: blocks there that end after the first of these begins are among these.
  std::vector<TimingBlock> blocks() const EXCLUDES(mutex_);

 private:
  struct Waiting {
    execution::JournalEntry input;
    Arrival arrival;
  };
  std::int64_t time_of(Clock::time_point time) const;
  static Moment moment_of(const execution::Execution& execution);
  void drop(Waiting&& waiting, Moment from) REQUIRES(mutex_);
  void drop_all(Moment from) REQUIRES(mutex_);
  void align(const execution::Execution& execution, Moment dropped, Moment now) REQUIRES(mutex_);
  void drop_older(const execution::JournalEntry& newest, Moment from) REQUIRES(mutex_);
  std::optional<Arrival> take_first(const execution::JournalEntry& entry, Moment dropped) REQUIRES(mutex_);
  void begin_block() REQUIRES(mutex_);
  Moment earliest(Moment now) const REQUIRES(mutex_);

  const Clock::time_point made_;  // the run
  mutable services::Mutex mutex_;
  std::deque<Waiting> waiting_ GUARDED_BY(mutex_);  // beside those of the execution
  TimingBlock block_ GUARDED_BY(mutex_);            // that grows
  std::size_t undelivered_units_ GUARDED_BY(mutex_) = 0;
  std::size_t states_ GUARDED_BY(mutex_) = 0;  // of services with which the block begins
  std::map<std::string, std::optional<std::string>> services_ GUARDED_BY(mutex_);  // as they are
  struct Written {
    std::uint64_t ticket;
    TimingBlock block;
  };
  std::deque<Written> written_ GUARDED_BY(mutex_);  // on their way to the disk
};

}  // namespace race::server
