// RemoteWorld: the server's end of what the components of a process act in: the world that the process brings with its
// hello, the poses that it shows while somebody watches, and acts in it with their answers. It knows nothing of the
// world itself: its Door says what fits.
//
// Threads: any; connect() and announce() on the unit's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/clock.h"
#include "services/remote/frame.h"
#include "services/remote/protocol.h"

namespace race::remote {

class RemoteWorld {
 public:
  static constexpr std::size_t kActs = 100;  // that wait for an answer

  /// How an act ended, once: on the unit's thread, or at once on that of act(). Frozen.
  using Done = std::function<void(Expected<Value>)>;

  /// What a world, a pose and an answer must be; errors lose the process.
  struct Door {
    std::function<Expected<void>(const Value& world)> world;
    std::function<Expected<void>(const Value& world, const Value& pose)> pose;
    std::function<Expected<void>(const Value& world, const Value& answer)> answer;
  };

  /// `show` gets each pose, frozen, on the unit's thread. The clock outlives it.
  RemoteWorld(const services::Clock& clock, Door door, std::function<void(Value)> show);

  /// Whether a process may bring this.
  Expected<void> check(const Value& world) const { return door_.world(world); }
  /// The world is there from now on: `world`, frozen, of `process`. nullptr: it is not, and all that waits is
  /// `unavailable`.
  void connect(std::shared_ptr<FrameQueue> process, Value world);
  /// The process has said something of its world. Requires a message of such a kind. Errors: those of the door;
  /// `conflict`: it answers what nobody waits for.
  Expected<void> announce(Message message);

  /// What the process brought, frozen; null: it is not there.
  Value world() const;
  /// Does an act (null: none) in the world. Errors: `unavailable`; the process'.
  void act(Value act, Done done);
  /// Somebody wants poses, or nobody any more.
  void watch(bool on);

 private:
  bool send(Message message);
  Expected<void> posed(const Value& pose);
  Expected<void> answered(const Message& message);

  const services::Clock& clock_;
  const Door door_;
  const std::function<void(Value)> show_;
  mutable std::mutex mutex_;             // of all below
  std::shared_ptr<FrameQueue> process_;  // held by its connection too
  Value world_;
  bool watched_ = false;
  std::map<std::int64_t, Done> waiting_;  // by the act's number
  std::int64_t acts_ = 0;
};

}  // namespace race::remote
