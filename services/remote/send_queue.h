// EncodedMessage: one WebSocket message, whatever carries it; SendQueue: those that wait to be sent to one end. It is
// bounded: who reads nothing is not written to for ever, and of the packets of one flow only the newest waits.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace race::remote {

struct EncodedMessage {
  std::string bytes;
  bool binary = false;  // else UTF-8 text
};

class SendQueue {
 public:
  static constexpr std::size_t kBytes = 64 * 1024 * 1024;

  /// `flow`, if it is not empty: the frame takes the place of one that waits under the same name. false: the queue is
  /// full or closed, and the frame lost.
  bool push(EncodedMessage frame, const std::string& flow = {});
  std::optional<EncodedMessage> pop();

  /// `wake` is called after each push and close(), on its thread and under the lock; an empty one ends that.
  void on_change(std::function<void()> wake);
  /// Nothing more is taken; what waits can still be popped.
  void close();
  /// Whether it is closed and empty.
  bool drained() const;

 private:
  struct Waiting {
    EncodedMessage frame;
    std::string flow;
  };

  mutable std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::size_t bytes_ = 0;
  std::function<void()> wake_;
  bool closed_ = false;
};

}  // namespace race::remote
