// A Component is an RSM plus code; a ServiceHost is what it talks to. A component announces transitions, responses and
// events; it never sees a core, and a core cannot tell where a component runs.
//
// Threads: all functions of one component are called on one thread, its group's; it calls its host on that thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::services {

/// Names a call for its whole life; unique within a host.
using CallId = std::uint64_t;

/// One call of an operation. `args` by position, `kwargs` by name, as a task wrote them.
struct Call {
  CallId id = 0;
  std::string operation;
  List args;
  Dict kwargs;
};

/// Seconds of the clock that all services and the server share: world time where there is a world, else steady time.
using Time = double;

/// What a service gives to other services on one of its flows (thesis 4.1: data-flow), past all cores: images, clouds.
/// Immutable once it is published, and shared by its subscribers; the header is frozen.
struct Packet {
  Time time = 0;  // when its content was measured
  Value header;
  std::vector<std::byte> bytes;
};
using PacketPtr = std::shared_ptr<const Packet>;

/// An answer that is due: names a reservation until it is fulfilled. 0: none.
using ReservationId = std::uint64_t;

/// What a component may do. The host monitors: it holds every announcement against the component's RSM and records what
/// does not fit, with rule and call id (R18); it delivers nevertheless.
class ServiceHost {
 public:
  virtual ~ServiceHost() = default;
  virtual Time now() const = 0;
  /// The component takes transition `id`, by `call` if the transition has an operation (0: spontaneous), or to answer
  /// `call`, one of several (R25).
  virtual void transition(std::string_view id, CallId call = 0) = 0;
  /// Answers a call: once, now or later. `error` is a dict with at least `code`.
  virtual void result(CallId call, Value value) = 0;
  virtual void error(CallId call, Value error) = 0;
  /// Rejects a call that the component's present state accepts in no transition: answers {"code": "not_accepted"} (R7).
  virtual void reject(CallId call) = 0;
  virtual void event(std::string_view name, Value data) = 0;

  // Data flows and answers that are due. A host without other services may do nothing with them.

  /// Hands a packet to all subscribers of `flow` of this service.
  virtual void publish(std::string_view /*flow*/, PacketPtr /*packet*/) {}
  /// Subscribes, or no longer, to `flow` of the service `key`, which this component's RSM lists in `subscribes`.
  virtual void subscribe(std::string_view /*key*/, std::string_view /*flow*/, bool /*on*/) {}
  /// Announces an answer as of world time `at`, which another thread will prepare: where world time can wait, it does
  /// not pass `at` before fulfil(), so a run does not depend on how fast that thread is. In real time it does not wait.
  virtual ReservationId reserve(Time /*at*/) { return 0; }
  /// Ends a reservation: `answer` runs on the component's group at its time, or at once if that has passed; an empty
  /// one gives the time back. On any thread, once.
  virtual void fulfil(ReservationId /*reservation*/, std::function<void()> /*answer*/) {}

  /// For people, never for programs.
  virtual void log(std::string text) = 0;
};

struct Violation;  // services/host/call_ledger.h

class Component {
 public:
  virtual ~Component() = default;
  /// Its RSM, fixed for its life.
  virtual const rsm::Service& model() const = 0;
  /// A call arrived. The component accepts it (transition, later result or error) or rejects it, before it returns.
  virtual void call(const Call& call) = 0;
  /// Nobody can receive the response to this call any more, which has had none yet: its caller has called the operation
  /// again, or is over. A component that holds resources for it may end it; it must still answer, once. What the
  /// service does goes on: a motion is not stopped.
  virtual void abandoned(CallId /*call*/) {}
  /// World time has advanced by one step of the group (1 ms in a cell). Only components that need time override it.
  virtual void step() {}
  /// A packet came of a flow that the component subscribes to. One that comes while another still waits replaces it.
  virtual void packet(std::string_view /*key*/, std::string_view /*flow*/, const PacketPtr& /*packet*/) {}
  /// `flow` of this service has subscribers from now on, or none any more. At first it has none.
  virtual void demand_changed(std::string_view /*flow*/, bool /*on*/) {}
  /// Nobody has been heard who could call it, for too long: it comes to a state in which nothing moves, as its RSM
  /// allows, and answers what it was doing with an error. It is called further when somebody is heard again.
  virtual void halt() {}
  /// What moves must not be faster than this from now on [m/s, at least 0; nothing: no limit], whatever the calls ask
  /// for: somebody is near. At first there is none. Motions that go on slow down, as fast as braking allows.
  virtual void limit_speed(std::optional<double> /*tool_speed*/) {}
  /// What it has announced does not fit its RSM (R18): for its author. It was delivered nevertheless.
  virtual void violated(const Violation& /*violation*/) {}
  /// The host is about to end; nothing may be called on it afterwards.
  virtual void stop() {}
};

/// {"code": code, "message": text}, the shape of every error response.
Value error_value(std::string_view code, std::string_view message);

}  // namespace race::services
