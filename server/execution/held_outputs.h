// HeldOutputs: what a core wants to say, in order, held until what caused it is durable (core/SEMANTICS.md section 10).
// Every record that a core hands to the journal has a ticket; an output waits for the last ticket of its time.
//
// Threads: the core's strand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

#include "core/value/expected.h"

namespace race::server {

class HeldOutputs {
 public:
  /// Says it (null), or learns that it never may be said: the journal has failed.
  using Output = std::function<void(const Error* failure)>;

  /// The next record of the journal has this ticket, from 1.
  std::uint64_t next_ticket() { return ++issued_; }
  /// What comes of all records so far. Said at once if they are durable.
  void add(Output output) {
    if (durable_ == issued_ && held_.empty()) return output(nullptr);
    held_.push_back({issued_, std::move(output)});
  }
  /// The records up to `ticket` are durable: what came of them is said.
  void release(std::uint64_t ticket) {
    durable_ = ticket;
    while (!held_.empty() && held_.front().ticket <= ticket) take_first()(nullptr);
  }
  /// What is held will never be said. Who asked is told why.
  void fail(const Error& error) {
    durable_ = issued_;
    while (!held_.empty()) take_first()(&error);
  }
  std::size_t size() const { return held_.size(); }

 private:
  struct Held {
    std::uint64_t ticket;
    Output output;
  };
  Output take_first() {
    Output output = std::move(held_.front().output);
    held_.pop_front();
    return output;
  }

  std::deque<Held> held_;
  std::uint64_t issued_ = 0, durable_ = 0;
};

}  // namespace race::server
