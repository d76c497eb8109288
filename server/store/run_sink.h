// RunSink: what a run hears of its records on their way to the disk.
#pragma once

#include <cstdint>

#include "core/value/expected.h"

namespace race::server {

/// Hears what became of a run's records. Must be quick; on any thread.
class RunSink {
 public:
  virtual ~RunSink() = default;
  /// The records up to the one of `ticket` are durable.
  virtual void durable(std::uint64_t ticket) = 0;
  /// The disk has not answered for too long: nothing is durable from now on. Once; failed() follows when it has
  /// answered, even if it says that all is well: who has been told otherwise must not go on.
  virtual void stalled(const Error& error) = 0;
  /// The records after the last durable one are stored or not, which the store says, and none will be. Once.
  /// `not_found`: the run is not in the store.
  virtual void failed(const Error& error) = 0;
};

}  // namespace race::server
