#include "server/cell/waiting_acts.h"

#include <atomic>
#include <future>
#include <memory>

namespace race::server {
namespace {

// Held by who waits and by the act, which may come later than anybody waits.
struct Turn {
  std::atomic<bool> decided{false};  // the act has begun, or was given up
  std::promise<Expected<Value>> answer;

  /// Whether this is the first to decide.
  bool take() { return !decided.exchange(true); }
};

}  // namespace

Expected<Value> WaitingActs::wait(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start) {
  {
    std::unique_lock lock(mutex_);
    if (!free_.wait_for(lock, patience_.place, [this] { return waiting_ < kPlaces; }))
      return unexpected(ErrorCode::unavailable, "other acts wait for the cell already; this one is not done");
    ++waiting_;
  }
  const auto turn = std::make_shared<Turn>();
  auto answer = turn->answer.get_future();
  start([turn] { return turn->take(); }, [turn](Expected<Value> person) { turn->answer.set_value(std::move(person)); });
  constexpr auto kReady = std::future_status::ready;
  bool answered = answer.wait_for(patience_.begin) == kReady;
  const bool given_up = !answered && turn->take();
  if (!answered && !given_up) answered = answer.wait_for(patience_.end) == kReady;
  {
    const std::lock_guard lock(mutex_);
    --waiting_;
  }
  free_.notify_one();
  if (answered) return answer.get();
  return unexpected(ErrorCode::unavailable, given_up ? "the cell does not answer; this is not done"
                                                     : "the cell has begun this and does not answer; it may be done");
}

}  // namespace race::server
