// MessageQueue: messages that wait for one end of a connection, or for the thread of a group. It is bounded: of the
// packets of one flow only the newest waits, and once another message finds no room, that end is too slow to be told
// everything: the queue is closed, what waits is dropped, and the connection is to end. So no call or answer is lost
// without a word.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "services/mutex.h"

namespace race::remote {

/// `M` has size_of(M): its bytes.
template <typename M>
class MessageQueue {
 public:
  static constexpr std::size_t kBytes = 64 * 1024 * 1024;
  static constexpr std::size_t kOverheadBytes = 256;  // that a message takes beside its own

  /// `flow`, if it is not empty: the message replaces one that waits under the same name, and is dropped if there is no
  /// room. false: it is dropped, as the queue is full or closed.
  bool push(M message, const std::string& flow = {}) EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    if (closed_) return false;
    if (!flow.empty()) drop_older(flow);
    const std::size_t bytes = size_of(message) + kOverheadBytes;
    const bool has_room = bytes_ + bytes <= kBytes;
    if (has_room) {
      bytes_ += bytes;
      waiting_.push_back({std::move(message), bytes, flow});
      if (!flow.empty()) newest_[flow] = std::prev(waiting_.end());
    } else if (flow.empty()) {
      overflow();
    }
    if (wake_ && (has_room || closed_)) wake_();
    return has_room;
  }

  std::optional<M> pop() EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    std::optional<M> next(std::move(waiting_.front().message));
    remove(waiting_.begin());
    return next;
  }

  /// `wake` is called after each push and close(), on its thread and under the lock; an empty one ends that.
  void on_change(std::function<void()> wake) EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    wake_ = std::move(wake);
  }
  /// Nothing more is taken; what waits can still be popped.
  void close() EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    closed_ = true;
    if (wake_) wake_();
  }

  std::size_t size() const EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    return waiting_.size();
  }
  /// Whether it is closed and empty.
  bool drained() const EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    return closed_ && waiting_.empty();
  }
  /// Whether it was closed because a message found no room.
  bool overflowed() const EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    return overflowed_;
  }

 private:
  struct Waiting {
    M message;
    std::size_t bytes = 0;
    std::string flow;
  };
  using Messages = std::list<Waiting>;

  void remove(typename Messages::iterator message) REQUIRES(mutex_) {
    bytes_ -= message->bytes;
    if (!message->flow.empty()) newest_.erase(message->flow);
    waiting_.erase(message);
  }
  void drop_older(const std::string& flow) REQUIRES(mutex_) {
    if (const auto older = newest_.find(flow); older != newest_.end()) remove(older->second);
  }
  void overflow() REQUIRES(mutex_) {
    overflowed_ = closed_ = true;
    newest_.clear();
    waiting_.clear();
    bytes_ = 0;
  }

  mutable services::Mutex mutex_;
  Messages waiting_ GUARDED_BY(mutex_);
  std::map<std::string, typename Messages::iterator> newest_ GUARDED_BY(mutex_);  // of those, by flow
  std::size_t bytes_ GUARDED_BY(mutex_) = 0;
  std::function<void()> wake_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  bool overflowed_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::remote
