// Timing: when what happened in a run: beside its journal, which has no clock, and of which nothing here is a part. A
// run is the same without it, and whoever reads it must be ready for what is not known.
//
// It comes in blocks, each of some seconds. What waited at an earlier moment (execution/waiting_then.h) is known from
// the first moment of a block, `since`, to before its last one, `until`: what had come before `until` and is in no
// block was delivered or dropped before `since`.
//
// Values and pure functions.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/execution/journal.h"
#include "core/value/value.h"

namespace race::server {

/// A moment of a run: after `micro` micro steps of macro step `step`, or at its end.
struct Moment {
  static constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t step = 0;
  std::uint32_t micro = kEnd;
  auto operator<=>(const Moment&) const = default;
};

// All times: [us] since the run was made (RunRecord::created_ms).

/// When something came that waits to be delivered.
struct Arrival {
  std::int64_t time = 0;
  Moment moment;
  bool operator==(const Arrival&) const = default;
};

/// Of a macro step: when it began, and when the event or response came that it delivers.
struct StepTime {
  std::int64_t time = 0;
  std::optional<Arrival> input = {};
  bool operator==(const StepTime&) const = default;
};

/// An input that waited and is no entry of the journal: a newer sample came, it counted no more, or the run ended.
struct Undelivered {
  execution::JournalEntry input;
  Arrival arrival;
  Moment dropped;  // from then on it did not wait
  bool operator==(const Undelivered&) const = default;
};

/// The state of a service from then on.
struct ServiceChange {
  std::int64_t time = 0;
  std::string service;
  std::optional<std::string> state;  // none: it is not available
  bool operator==(const ServiceChange&) const = default;
};

struct TimingBlock {
  // Of a block.
  static constexpr std::size_t kMostSteps = 2048, kMostUndelivered = 100, kMostChanges = 2048;
  static constexpr std::size_t kLongestName = 200;              // [bytes]
  static constexpr std::size_t kUndeliveredUnits = 32U << 10U;  // Value::size_units
  static constexpr std::size_t kMostBlocks = 2048;              // of a run; then the oldest go

  std::uint64_t first = 1;      // macro step, of `steps`
  std::vector<StepTime> steps;  // those that follow each other; may be none
  std::int64_t begins = 0, ends = 0;
  Moment since, until;
  std::vector<Undelivered> undelivered;
  std::vector<ServiceChange> services;  // first the states when the block begins, then what changed; in order of time

  std::uint64_t last() const { return first + steps.size() - 1; }
  bool operator==(const TimingBlock&) const = default;
};

/// An item of schemas/timing_block.json.
Value timing_json(const TimingBlock& block);
/// Reads what timing_json wrote. Errors at `path`: those of Fields and execution::read_input, `too_large`,
/// `out_of_range`.
TimingBlock read_timing(const Value& json, const std::string& path, std::vector<Error>& errors);

}  // namespace race::server
