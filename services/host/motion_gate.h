// MotionGate: whether a call may set the cell in motion; the host asks it where calls of operations that `moves` arrive
// at their service, in order with its own transitions.
//
// Threads: any; must be quick, and calls no host.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/call_ledger.h"

namespace race::services {

class MotionGate {
 public:
  virtual ~MotionGate() = default;
  /// A run begins or goes on because a person wants that: the fencing number of its calls from now on. Error `stopped`.
  virtual Expected<std::uint64_t> begin() = 0;
  /// Why the call may not set `service` in motion, as the error that answers it; nothing: it may.
  virtual std::optional<Value> refuse(const Caller& caller, const std::string& service) = 0;
  /// `core` makes no call of `service` any more.
  virtual void release(const std::string& core, const std::string& service) = 0;
};

/// Lets everything pass: of a run that has its cell for itself (`race run`).
class OpenGate final : public MotionGate {
 public:
  Expected<std::uint64_t> begin() override { return 0; }
  std::optional<Value> refuse(const Caller&, const std::string&) override { return std::nullopt; }
  void release(const std::string&, const std::string&) override {}
};

}  // namespace race::services
