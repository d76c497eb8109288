#include "server/mcp/calls.h"

#include <algorithm>

namespace race::server::mcp {

tl::expected<SharedStop, RpcError> Calls::begin(const Value& id, std::size_t most) {
  const services::MutexLock lock(mutex_);
  if (std::ranges::any_of(open_, [&](const auto& call) { return call.first == id; }))
    return tl::unexpected(RpcError{RpcCode::invalid_request, "id: a request with this id is being worked on"});
  if (count_ >= most)
    return tl::unexpected(
        RpcError{RpcCode::busy, std::to_string(most) + " requests are being worked on already; wait for one of them"});
  auto stop = std::make_shared<Stop>(false);
  open_.emplace_back(id, stop);
  ++count_;
  return stop;
}

void Calls::close(const Value& id) {
  const services::MutexLock lock(mutex_);
  std::erase_if(open_, [&](const auto& call) { return call.first == id; });
}

void Calls::end() {
  const services::MutexLock lock(mutex_);
  --count_;
  ended_.notify_all();
}

void Calls::cancel(const Value& id) {
  const services::MutexLock lock(mutex_);
  for (const auto& [its_id, stop] : open_)
    if (its_id == id) *stop = true;
}

void Calls::cancel_all() {
  const services::MutexLock lock(mutex_);
  for (const auto& [id, stop] : open_) *stop = true;
}

bool Calls::wait_until_none(std::chrono::milliseconds time) {
  const services::MutexLock lock(mutex_);
  return ended_.wait_for(mutex_, time, [this]() REQUIRES(mutex_) { return count_ == 0; });
}

}  // namespace race::server::mcp
