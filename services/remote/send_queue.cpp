#include "services/remote/send_queue.h"

#include <algorithm>

namespace race::remote {

bool SendQueue::push(EncodedMessage frame, const std::string& flow) {
  const std::lock_guard lock(mutex_);
  if (closed_) return false;
  const auto older =
      std::ranges::find_if(waiting_, [&](const Waiting& each) { return !flow.empty() && each.flow == flow; });
  if (older != waiting_.end()) {
    bytes_ -= older->frame.bytes.size();
    waiting_.erase(older);
  }
  if (bytes_ + frame.bytes.size() > kBytes) return false;
  bytes_ += frame.bytes.size();
  waiting_.push_back({std::move(frame), flow});
  if (wake_) wake_();
  return true;
}

std::optional<EncodedMessage> SendQueue::pop() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  EncodedMessage next = std::move(waiting_.front().frame);
  waiting_.pop_front();
  bytes_ -= next.bytes.size();
  return next;
}

void SendQueue::on_change(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

void SendQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  if (wake_) wake_();
}

bool SendQueue::drained() const {
  const std::lock_guard lock(mutex_);
  return closed_ && waiting_.empty();
}

}  // namespace race::remote
