// What waited to be delivered at an earlier moment of a run, by what is known of its times.
//
// Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "server/store/timing.h"

namespace race::server {

/// One that waited: it was delivered by macro step `step`, or is `undelivered`.
struct WaitedInput {
  std::int64_t time = 0;  // when it came
  std::uint64_t step = 0;
  std::optional<execution::JournalEntry> undelivered = {};
};

/// Takes blocks in order, from the one on that has the macro step after the moment, until it knows what waited then,
/// at the end of the moment: when the run went on from there.
class WaitingThen {
 public:
  explicit WaitingThen(const Moment& moment) : moment_(moment), next_(moment.step + 1) {}
  /// False: no more blocks are needed.
  bool take(const TimingBlock& block);
  /// In order of arrival; nothing: it is not known.
  std::optional<std::vector<WaitedInput>> inputs() const;

 private:
  bool waited(const Arrival& arrival) const { return arrival.moment <= moment_; }
  void add(const Arrival& arrival, WaitedInput input);

  const Moment moment_;
  std::uint64_t next_;  // macro step that is to come
  bool known_ = false, lost_ = false;
  struct Found {
    Arrival arrival;
    WaitedInput input;
  };
  std::vector<Found> found_;
};

}  // namespace race::server
