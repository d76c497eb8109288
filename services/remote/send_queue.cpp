#include "services/remote/send_queue.h"

#include <algorithm>

namespace race::remote {

bool SendQueue::push(EncodedMessage message, const std::string& flow) {
  const services::MutexLock lock(mutex_);
  if (closed_) return false;
  const auto older =
      std::ranges::find_if(waiting_, [&](const Waiting& each) { return !flow.empty() && each.flow == flow; });
  if (older != waiting_.end()) {
    bytes_ -= older->message.bytes.size();
    waiting_.erase(older);
  }
  if (bytes_ + message.bytes.size() > kBytes) return false;
  bytes_ += message.bytes.size();
  waiting_.push_back({std::move(message), flow});
  if (wake_) wake_();
  return true;
}

std::optional<EncodedMessage> SendQueue::pop() {
  const services::MutexLock lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  EncodedMessage next = std::move(waiting_.front().message);
  waiting_.pop_front();
  bytes_ -= next.bytes.size();
  return next;
}

void SendQueue::on_change(std::function<void()> wake) {
  const services::MutexLock lock(mutex_);
  wake_ = std::move(wake);
}

void SendQueue::close() {
  const services::MutexLock lock(mutex_);
  closed_ = true;
  if (wake_) wake_();
}

bool SendQueue::drained() const {
  const services::MutexLock lock(mutex_);
  return closed_ && waiting_.empty();
}

}  // namespace race::remote
