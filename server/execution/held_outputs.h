// HeldOutputs: what a core wants to say, in order, held until what caused it is durable (core/SEMANTICS.md section 10).
// Every record that a core hands to the journal has a ticket; an output waits for the last ticket of its time. What is
// held is bounded by the core: it does not go on while it is full.
//
// Threads: the core's strand.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

#include "core/value/expected.h"

namespace race::server {

class HeldOutputs {
 public:
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kMostUnits = 8U << 20U;

  /// Says it (null), or learns that it never may be said: the journal has failed.
  using Output = std::function<void(const Error* failure)>;

  /// The next record of the journal has this ticket, from 1.
  std::uint64_t next_ticket() { return ++issued_; }
  /// What comes of all records so far, and takes so many units (Value::size_units) of memory. Said at once if they are
  /// durable.
  void add(Output output, std::size_t units = 0, bool is_answer = false) {
    if (durable_ == issued_ && held_.empty()) return output(nullptr);
    held_.push_back({issued_, std::move(output), units, is_answer});
    units_ += units;
    answers_ += is_answer ? 1 : 0;
  }
  /// The records up to `ticket` are durable: what came of them may be said.
  void set_durable(std::uint64_t ticket) { durable_ = std::max(durable_, ticket); }
  bool is_due() const { return !held_.empty() && held_.front().ticket <= durable_; }
  /// Says the next that is due.
  void say_next() { take_first()(nullptr); }
  /// What is held will never be said. Who asked is told why.
  void fail(const Error& error) {
    durable_ = issued_;
    while (!held_.empty()) take_first()(&error);
  }
  /// Somebody waits.
  bool has_answers() const { return answers_ > 0; }
  std::size_t size() const { return held_.size(); }
  /// No further macro step should begin, and none go on.
  bool is_full() const { return held_.size() >= kMost || units_ >= kMostUnits; }

 private:
  struct Held {
    std::uint64_t ticket;
    Output output;
    std::size_t units;
    bool is_answer;
  };
  Output take_first() {
    Output output = std::move(held_.front().output);
    units_ -= held_.front().units;
    answers_ -= held_.front().is_answer ? 1 : 0;
    held_.pop_front();
    return output;
  }

  std::deque<Held> held_;
  std::size_t units_ = 0, answers_ = 0;  // of held_
  std::uint64_t issued_ = 0, durable_ = 0;
};

}  // namespace race::server
