// StepLog: the changes of a micro step, by which it is discarded when it ends in a fault (R4).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/semantics/context.h"

namespace race::semantics {

/// A call that was made, and the record of its caller's call before it, with its place among the others.
struct LoggedCall {
  OperationId operation = kNone;
  std::size_t place = 0;
  std::optional<CallRecord> before;
};

/// What stood where before, oldest first.
/// OPTIMIZATION: a vector that never shrinks, so that adding is a store in line.
template <typename Place, typename Old>
class Log {
 public:
  void add(Place place, Old old) {
    if (size_ == entries_.size()) grow();
    entries_[size_++] = {place, old};
  }
  void clear() { size_ = 0; }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  [[gnu::noinline]] void grow() { entries_.resize(2 * size_ + 16); }
  std::vector<std::pair<Place, Old>> entries_;
  std::size_t size_ = 0;
};

/// The changes of a micro step, for discarding it.
struct StepLog {
  ValueLog values;
  Log<Flag, std::uint8_t> flags;
  Log<PortId, std::uint8_t> arrived;
  Log<PortId, std::uint64_t> triggered;
  std::vector<LoggedCall> calls;
  void clear() {
    values.clear();
    flags.clear();
    arrived.clear();
    triggered.clear();
    calls.clear();
  }
  /// Restores what can be seen of a run: Π, Ξ, Λ, Φ, arrivals, calls and their responses, what R9 holds back. The lists
  /// below the rules and the work set stay as they are: the run does not go on.
  void undo(RunState& run);
};

/// What a run keeps between micro steps so that none of it is allocated again.
struct Workspace {
  StepLog log;
  std::vector<OutgoingCall> outgoing;  // of the micro step
  std::vector<ValueIndex> changed;     // values, for count_data()
  std::vector<PortId> ports;           // the list of a PTrans1
  std::vector<BarrierId> barriers;     // the list of a PTrans2
};

}  // namespace race::semantics
