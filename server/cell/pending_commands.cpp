#include "server/cell/pending_commands.h"

#include <utility>

namespace race::server {

// Shared by who asked and the cell, where it may come to its turn when the time is over.
struct PendingCommands::Command {
  Command(Done<Value> done, std::shared_ptr<std::atomic<int>> all)
      : pending(std::move(all)), answer([this, done = std::move(done)](Expected<Value> person) {
          --*pending;
          answered = true;
          done(std::move(person));
        }) {}
  Command(const Command&) = delete;
  ~Command() {
    if (!answered) --*pending;  // dropped: the cell ends
  }
  /// Whether this is the first to decide.
  bool decide() { return !decided.exchange(true); }

  const std::shared_ptr<std::atomic<int>> pending;
  std::atomic<bool> decided{false};  // it has begun, or has timed out
  std::atomic<bool> answered{false};
  Once<Value> answer;
};

void PendingCommands::start(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start, Deadlines& deadlines,
                            Done<Value> done) {
  if (++*pending_ > kMaxPending) {
    --*pending_;
    return done(unexpected(ErrorCode::unavailable, "other commands wait for the cell already; this one is not done"));
  }
  std::shared_ptr<Command> command;
  try {
    command = std::make_shared<Command>(std::move(done), pending_);
  } catch (...) {
    --*pending_;
    throw;
  }
  deadlines.after(timeouts_.completion, [weak = std::weak_ptr(command), grace = timeouts_.grace, &deadlines] {
    const auto late = weak.lock();
    if (!late) return;
    if (late->decide())
      return late->answer(unexpected(ErrorCode::unavailable, "the cell does not answer; this is not done"));
    deadlines.after(grace, [weak] {
      if (const auto begun = weak.lock())
        begun->answer(
            unexpected(ErrorCode::unavailable, "the cell has begun this and does not answer; it may be done"));
    });
  });
  start([command] { return command->decide(); },
        [command](Expected<Value> person) { command->answer(std::move(person)); });
}

}  // namespace race::server
