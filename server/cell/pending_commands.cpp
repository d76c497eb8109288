#include "server/cell/pending_commands.h"

#include <atomic>
#include <future>
#include <memory>

namespace race::server {
namespace {

// Shared by the waiting thread and the command, which may run after the wait has timed out.
struct PendingCommand {
  std::atomic<bool> decided{false};  // the command has begun, or has timed out
  std::promise<Expected<Value>> answer;

  /// Whether this is the first to decide.
  bool take() { return !decided.exchange(true); }
};

}  // namespace

Expected<Value> PendingCommands::wait(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start) {
  {
    const services::MutexLock lock(mutex_);
    if (!free_.wait_for(mutex_, timeouts_.admission, [this]() REQUIRES(mutex_) { return pending_ < kMaxPending; }))
      return unexpected(ErrorCode::unavailable, "other commands wait for the cell already; this one is not done");
    ++pending_;
  }
  const auto command = std::make_shared<PendingCommand>();
  auto answer = command->answer.get_future();
  start([command] { return command->take(); },
        [command](Expected<Value> person) { command->answer.set_value(std::move(person)); });
  constexpr auto kReady = std::future_status::ready;
  bool answered = answer.wait_for(timeouts_.completion) == kReady;
  const bool given_up = !answered && command->take();
  if (!answered && !given_up) answered = answer.wait_for(timeouts_.grace) == kReady;
  {
    const services::MutexLock lock(mutex_);
    --pending_;
  }
  free_.notify_one();
  if (answered) return answer.get();
  return unexpected(ErrorCode::unavailable, given_up ? "the cell does not answer; this is not done"
                                                     : "the cell has begun this and does not answer; it may be done");
}

}  // namespace race::server
