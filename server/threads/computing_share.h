// ComputingShare: whether somebody computes more than a share of the time, on average; what was saved up pays for a
// burst.
//
// Threads: add() on one at a time; is_over() on any.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

#include "services/computed_time.h"

namespace race::server {

class ComputingShare {
  using Clock = std::chrono::steady_clock;

 public:
  static constexpr int kPart = 32;                            // of the time of a processor: one in so many
  static constexpr std::chrono::milliseconds kBurst{2};       // of computing
  static constexpr std::chrono::milliseconds kLongest{1000};  // that it is over, however long was computed

  /// So long was computed until `now`.
  void add(std::chrono::nanoseconds computed, Clock::time_point now) {
    const auto paid = std::max(paid_until_.load(), now - kPart * kBurst) + kPart * computed;
    paid_until_ = std::min(paid, now + kLongest);
  }
  bool is_over(Clock::time_point now) const { return now < paid_until_.load(); }

 private:
  std::atomic<Clock::time_point> paid_until_{};
};

/// Adds what this thread computes while it lives. What counts is the time of the processor: a machine under load makes
/// nobody a busy one.
class Measurement {
 public:
  explicit Measurement(ComputingShare& share) : share_(share) {}
  ~Measurement() { share_.add(services::thread_time() - begin_, std::chrono::steady_clock::now()); }
  Measurement(const Measurement&) = delete;
  Measurement& operator=(const Measurement&) = delete;

 private:
  ComputingShare& share_;
  const std::chrono::nanoseconds begin_ = services::thread_time();
};

}  // namespace race::server
