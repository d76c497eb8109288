// RemoteWorld: the server's end of the world that the components of a process act in: the world that the process brings
// with its hello, the poses that it sends while somebody watches, and commands with their answers. It knows nothing of
// the world itself: its Validator says what is valid.
//
// A command is sent in two steps: it is offered to the process and, once the process is ready for it, confirmed by its
// caller. So a process that hung does not execute a command whose caller has given up.
//
// Threads: any; connect() and announce() on the group's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/clock.h"
#include "services/mutex.h"
#include "services/remote/protocol.h"
#include "services/remote/send_queue.h"

namespace race::remote {

/// Error `unavailable`: there is no process that brought a world.
tl::unexpected<Error> no_world();

class RemoteWorld {
 public:
  static constexpr std::size_t kMaxPendingCommands = 100;  // that wait for an answer

  /// The answer to a command, frozen; called once, on the group's thread, or at once on that of execute().
  using Done = std::function<void(Expected<Value>)>;
  /// Whether the command is to be executed; called once, when the process is ready for it. After a yes the process
  /// executes it, if it lives. On the group's thread, under the lock: must not call the RemoteWorld.
  using Confirm = std::function<bool()>;

  /// What poses and answers of a world must be; an error disconnects the process.
  struct Rules {
    std::function<Expected<void>(const Value& pose)> pose;
    std::function<Expected<void>(const Value& answer)> answer;
  };
  /// A valid world, frozen.
  struct World {
    Value value;
    Rules rules;
  };
  /// What a world must be; an error refuses the process.
  using Validator = std::function<Expected<Rules>(const Value& world)>;

  /// `show` gets each pose, frozen, on the group's thread. The clock outlives it.
  RemoteWorld(const services::Clock& clock, Validator validate, std::function<void(Value)> show);

  /// Whether a process may bring this world. On any thread; takes its time.
  Expected<World> check(Value world) const;
  /// `process` has connected with its world; nullptr: it has disconnected, and the commands that wait are answered
  /// `unavailable`.
  void connect(std::shared_ptr<SendQueue> process, World world) EXCLUDES(mutex_);
  /// A message of the process about its world. Requires a message of such a kind. Errors: those of the Rules;
  /// `conflict`: it is about no command that waits.
  Expected<void> announce(Message message) EXCLUDES(mutex_);

  /// What the process brought, frozen; null: no process is connected.
  Value world() const EXCLUDES(mutex_);
  /// Offers a command (null: none, its answer alone) to the process, which executes it once `confirm` has said yes.
  /// After a no it is dropped, and `done` is not called. Errors: `unavailable`, with the reason; those of the process.
  void execute(Value command, Confirm confirm, Done done) EXCLUDES(mutex_);
  /// Whether the process is to send poses.
  void watch(bool on) EXCLUDES(mutex_);

 private:
  struct Command {
    Value what;
    Confirm confirm;
    Done done;
    bool sent = false;  // to the process, which executes it
  };

  Expected<void> send(Message message) REQUIRES(mutex_);
  Expected<void> offer(Command& command) REQUIRES(mutex_);
  Expected<void> handle_ready(std::int64_t number) EXCLUDES(mutex_);
  Expected<void> handle_pose(const Value& pose) EXCLUDES(mutex_);
  Expected<void> handle_answer(const Message& message) EXCLUDES(mutex_);

  const services::Clock& clock_;
  const Validator validate_;
  const std::function<void(Value)> show_;
  mutable services::Mutex mutex_;
  std::shared_ptr<SendQueue> process_ GUARDED_BY(mutex_);  // held by its connection too
  std::shared_ptr<const World> world_ GUARDED_BY(mutex_);  // of the process
  bool watched_ GUARDED_BY(mutex_) = false;
  std::map<std::int64_t, Command> pending_ GUARDED_BY(mutex_);  // by number
  std::int64_t last_number_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::remote
