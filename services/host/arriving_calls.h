// ArrivingCalls: how many calls are on their way to a service, and the units of their arguments: with as many as may
// wait for its responses, more have no place.
//
// Threads: any.
#pragma once

#include <atomic>
#include <cstddef>

#include "services/host/call_ledger.h"

namespace race::services {

class ArrivingCalls {
 public:
  /// False: there is no place for a call with arguments of so many units. `always`: there is.
  bool add(std::size_t units, bool always = false) {
    if (!always && (count_ >= CallLedger::kMostPending || units_ > CallLedger::kMostPendingUnits)) return false;
    ++count_;
    units_ += units;
    return true;
  }
  /// It has arrived.
  void remove(std::size_t units) {
    --count_;
    units_ -= units;
  }
  std::size_t count() const { return count_; }

 private:
  std::atomic<std::size_t> count_{0}, units_{0};
};

}  // namespace race::services
