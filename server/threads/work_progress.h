// WorkProgress: how far work that takes long has come, for who waits for it.
//
// Threads: any.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "services/mutex.h"

namespace race::server {

class WorkProgress {
 public:
  struct State {
    std::uint64_t done = 0, total = 0;  // done <= total
    const char* unit = "";              // of both, a literal: "bytes"
  };

  /// How much there is to do; of nothing, nothing is told. Once.
  void begin(std::uint64_t total, const char* unit) EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    state_ = {0, total, unit};
  }
  /// So much of all is done. What is less than before, or more than all, counts as that.
  void reach(std::uint64_t done) EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    state_.done = std::clamp(done, state_.done, state_.total);
  }
  void finish() EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    state_.done = state_.total;
  }
  /// Nothing: it is not known how much there is.
  std::optional<State> state() const EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    return state_.total == 0 ? std::nullopt : std::optional(state_);
  }

 private:
  mutable services::Mutex mutex_;
  State state_ GUARDED_BY(mutex_);
};

/// Shared by who works and who waits.
using SharedWorkProgress = std::shared_ptr<WorkProgress>;

/// A part of it, done by work that counts in something else, such as pages.
class WorkPart {
 public:
  /// Of work that nobody waits for.
  WorkPart() = default;
  /// The next `size` after the first `before`. The WorkProgress, which outlives this, may be null: nobody waits.
  WorkPart(WorkProgress* whole, std::uint64_t before, std::uint64_t size)
      : whole_(whole), before_(before), size_(size) {}
  /// `done` of `all` that this work counts; nothing while `all` is 0.
  void reach(std::uint64_t done, std::uint64_t all) const {
    if (!whole_ || all == 0) return;
    const double share = static_cast<double>(done) / static_cast<double>(all);
    whole_->reach(before_ + static_cast<std::uint64_t>(share * static_cast<double>(size_)));
  }
  void finish() const { reach(1, 1); }

 private:
  WorkProgress* whole_ = nullptr;
  std::uint64_t before_ = 0, size_ = 0;
};

/// Gives the pieces of some work their parts, one after the other.
class WorkParts {
 public:
  /// Begins it, if it is not null; it outlives this.
  WorkParts(WorkProgress* whole, std::uint64_t total, const char* unit) : whole_(whole) {
    if (whole) whole->begin(total, unit);
  }
  WorkPart next(std::uint64_t size) { return {whole_, std::exchange(given_, given_ + size), size}; }

 private:
  WorkProgress* whole_;
  std::uint64_t given_ = 0;
};

}  // namespace race::server
