// A Component is an RSM plus code; a ServiceHost is what it talks to. A component announces transitions, responses and
// events; it never sees a core, and a core cannot tell where a component runs.
//
// Threads: all functions of one component are called on one thread, its unit's; it calls its host on that thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

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

/// What a component may do. The host monitors: it holds every announcement against the component's RSM and records what
/// does not fit, with rule and call id (R18); it delivers nevertheless.
class ServiceHost {
 public:
  virtual ~ServiceHost() = default;
  virtual Time now() const = 0;
  /// The component takes transition `id`, by `call` if the transition has an operation (0: spontaneous).
  virtual void transition(std::string_view id, CallId call = 0) = 0;
  /// Answers a call: once, now or later. `error` is a dict with at least `code`.
  virtual void result(CallId call, Value value) = 0;
  virtual void error(CallId call, Value error) = 0;
  /// Rejects a call that the component's present state accepts in no transition: answers {"code": "not_accepted"} (R7).
  virtual void reject(CallId call) = 0;
  virtual void event(std::string_view name, Value data) = 0;
  /// For people, never for programs.
  virtual void log(std::string text) = 0;
};

class Component {
 public:
  virtual ~Component() = default;
  /// Its RSM, fixed for its life.
  virtual const rsm::Service& model() const = 0;
  /// A call arrived. The component accepts it (transition, later result or error) or rejects it, before it returns.
  virtual void call(const Call& call) = 0;
  /// World time has advanced by one step of the unit (1 ms in a cell). Only components that need time override it.
  virtual void step() {}
  /// The host is going away; nothing may be called on it afterwards.
  virtual void stop() {}
};

/// {"code": code, "message": text}, the shape of every error response.
Value error_value(std::string_view code, std::string_view message);

}  // namespace race::services
