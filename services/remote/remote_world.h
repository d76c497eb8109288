// RemoteWorld: the server's end of what the components of a process act in: the world that the process brings with its
// hello, the poses that it shows while somebody watches, and acts in it with their answers. It knows nothing of the
// world itself: its Validator says what fits.
//
// Threads: any; connect() and announce() on the group's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/clock.h"
#include "services/remote/protocol.h"
#include "services/remote/send_queue.h"

namespace race::remote {

/// Error `unavailable`: there is no process that brought a world.
tl::unexpected<Error> no_world();

class RemoteWorld {
 public:
  static constexpr std::size_t kPendingCommands = 100;  // that wait for an answer

  /// How an act ended, once: on the group's thread, or at once on that of execute(). Frozen.
  using Done = std::function<void(Expected<Value>)>;
  /// Whether the act is still wanted, asked once: when the process is ready for it. After a yes it is done, if the
  /// process lives. On the group's thread; does not come back here.
  using Confirm = std::function<bool()>;

  /// What poses and answers of a world must be; errors lose the process.
  struct Rules {
    std::function<Expected<void>(const Value& pose)> pose;
    std::function<Expected<void>(const Value& answer)> answer;
  };
  /// A world that was let in, frozen.
  struct World {
    Value value;
    Rules rules;
  };
  /// What a world must be; an error refuses the process.
  using Validator = std::function<Expected<Rules>(const Value& world)>;

  /// `show` gets each pose, frozen, on the group's thread. The clock outlives it.
  RemoteWorld(const services::Clock& clock, Validator validate, std::function<void(Value)> show);

  /// Whether a process may bring this. Any thread; takes its time.
  Expected<World> check(Value world) const;
  /// The world of `process` is there from now on. nullptr: it is not, and all that waits is `unavailable`.
  void connect(std::shared_ptr<SendQueue> process, World world);
  /// The process has said something of its world. Requires a message of such a kind. Errors: those of the validate;
  /// `conflict`: it answers what nobody waits for.
  Expected<void> announce(Message message);

  /// What the process brought, frozen; null: it is not there.
  Value world() const;
  /// Offers an act (null: none) to the process, which does it when it is ready, if it is `wanted` then; else it is
  /// forgotten, and `done` not called. Errors: `unavailable`, and why; the process'.
  void execute(Value act, Confirm confirm, Done done);
  /// Somebody wants poses, or nobody any more.
  void watch(bool on);

 private:
  struct Command {
    Value what;
    Confirm confirm;
    Done done;
    bool started = false;  // by the process
  };

  Expected<void> send(Message message);
  Expected<void> offer(Command& act);
  Expected<void> handle_ready(std::int64_t number);
  Expected<void> handle_pose(const Value& pose);
  Expected<void> handle_answer(const Message& message);

  const services::Clock& clock_;
  const Validator validate_;
  const std::function<void(Value)> show_;
  mutable std::mutex mutex_;            // of all below
  std::shared_ptr<SendQueue> process_;  // held by its connection too
  std::shared_ptr<const World> world_;  // of it
  bool watched_ = false;
  std::map<std::int64_t, Command> waiting_;  // by its number
  std::int64_t commands_ = 0;
};

}  // namespace race::remote
