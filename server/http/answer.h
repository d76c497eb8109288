// Answer: where the reply to a request goes.
//
// Threads: any.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "server/http/message.h"

namespace race::server {

/// Takes one reply, the first. Copies are the same one; if the last of them goes without a reply, it is 503: what was
/// to answer has ended, or failed.
class Answer {
 public:
  /// `deliver` is called once, on the thread that replies.
  explicit Answer(std::function<void(Reply)> deliver);
  /// Throws what `deliver` throws; another reply may follow then.
  void operator()(Reply reply) const;

 private:
  struct Delivery;
  std::shared_ptr<Delivery> delivery_;
};

}  // namespace race::server
