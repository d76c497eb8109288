// SendQueue: the encoded messages that wait to be sent to one end of a connection. It is bounded: an end that reads
// nothing is written to no more once it is full, and of the packets of one flow only the newest waits.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "services/mutex.h"

namespace race::remote {

/// One WebSocket message.
struct EncodedMessage {
  std::string bytes;
  bool binary = false;  // else UTF-8 text
};

class SendQueue {
 public:
  static constexpr std::size_t kBytes = 64 * 1024 * 1024;

  /// `flow`, if it is not empty: the message replaces one that waits under the same name. false: the queue is full or
  /// closed, and the message is dropped.
  bool push(EncodedMessage message, const std::string& flow = {}) EXCLUDES(mutex_);
  std::optional<EncodedMessage> pop() EXCLUDES(mutex_);

  /// `wake` is called after each push and close(), on its thread and under the lock; an empty one ends that.
  void on_change(std::function<void()> wake) EXCLUDES(mutex_);
  /// Nothing more is taken; what waits can still be popped.
  void close() EXCLUDES(mutex_);
  /// Whether it is closed and empty.
  bool drained() const EXCLUDES(mutex_);

 private:
  struct Waiting {
    EncodedMessage message;
    std::string flow;
  };

  mutable services::Mutex mutex_;
  std::deque<Waiting> waiting_ GUARDED_BY(mutex_);
  std::size_t bytes_ GUARDED_BY(mutex_) = 0;
  std::function<void()> wake_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::remote
