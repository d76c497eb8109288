#include "server/stream/outbox.h"

#include <algorithm>
#include <utility>

namespace race::server {

void Outbox::push(const std::string& channel, Text text, bool sampled) {
  const services::MutexLock lock(mutex_);
  if (is_cut_ || needs_snapshot_.contains(channel)) return;
  if (sampled) {
    const auto older = std::ranges::find(items_, channel, &Item::channel);
    if (older != items_.end()) {
      bytes_ = bytes_ - older->text->json.size() + text->json.size();
      older->text = std::move(text);
      return;
    }
  }
  bytes_ += text->json.size();
  items_.push_back({channel, std::move(text), sampled});
  // A lone message may be as large as it is: it is a snapshot or what a client asked for.
  while (items_.size() > 1 && (items_.size() > kMessages || bytes_ > kBytes)) {
    const auto victim = std::ranges::find(items_, false, &Item::sampled);
    const std::string slow = victim == items_.end() ? items_.front().channel : victim->channel;
    erase(slow);
    needs_snapshot_.emplace(slow, false);
  }
}

std::optional<Text> Outbox::pop() {
  std::vector<Text> one = pop_together(0);
  return one.empty() ? std::nullopt : std::optional(std::move(one.front()));
}

std::vector<Text> Outbox::pop_together(std::size_t limit) {
  const services::MutexLock lock(mutex_);
  std::vector<Text> texts;
  sending_ = 0;
  while (!items_.empty() && (texts.empty() || sending_ + items_.front().text->json.size() <= limit)) {
    sending_ += items_.front().text->json.size();
    texts.push_back(std::move(items_.front().text));
    items_.pop_front();
  }
  bytes_ -= sending_;
  return texts;
}

void Outbox::drop(const std::string& channel) {
  const services::MutexLock lock(mutex_);
  erase(channel);
  needs_snapshot_.erase(channel);
}

std::vector<std::string> Outbox::take_stale_channels() {
  const services::MutexLock lock(mutex_);
  if (!items_.empty()) return {};
  std::vector<std::string> stale;
  for (auto& [channel, taken] : needs_snapshot_)
    if (!std::exchange(taken, true)) stale.push_back(channel);
  return stale;
}

void Outbox::cut() {
  const services::MutexLock lock(mutex_);
  items_.clear();
  bytes_ = 0;
  is_cut_ = true;
  needs_snapshot_ = {{kPrivateQueue, false}};
}

bool Outbox::is_cut() const {
  const services::MutexLock lock(mutex_);
  return is_cut_;
}

bool Outbox::is_empty() const {
  const services::MutexLock lock(mutex_);
  return items_.empty() && std::ranges::all_of(needs_snapshot_, [](const auto& each) { return each.second; });
}

std::size_t Outbox::size() const {
  const services::MutexLock lock(mutex_);
  return items_.size();
}

std::size_t Outbox::bytes() const {
  const services::MutexLock lock(mutex_);
  return bytes_ + sending_;
}

void Outbox::erase(const std::string& channel) {
  std::erase_if(items_, [&](const Item& item) REQUIRES(mutex_) {
    if (item.channel != channel) return false;
    bytes_ -= item.text->json.size();
    return true;
  });
}

}  // namespace race::server
