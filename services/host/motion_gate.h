// MotionGate: whether a call may set the cell in motion; the host asks it where calls of operations that `moves` arrive
// at their service, in order with its own transitions.
//
// Threads: any; must be quick, and calls no host.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/rsm/call_effect.h"
#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/call_ledger.h"

namespace race::services {

/// How a run begins, or goes on.
struct Beginning {
  std::string core;
  std::uint64_t control = 0;  // of the person at the controls who wants that; 0: somebody who has not taken them
  bool supervised = false;    // it moves only while that person has them
};

class MotionGate {
 public:
  virtual ~MotionGate() = default;
  /// A run begins or goes on because a person wants that: the fencing number of its calls from now on. Errors
  /// `stopped`; `leased`: somebody else has the controls; `conflict`: nobody has, and this run needs that.
  virtual Expected<std::uint64_t> begin(const Beginning& run) = 0;
  /// A person sets a value of a run that has begun, or takes one of its ports: by that it may move. Errors as of
  /// begin(), but for `stopped`, as all runs have ended then.
  virtual Expected<void> may_force(const Beginning& run) = 0;
  /// Whether an edit reaches this run only when the person at the controls has confirmed it.
  virtual bool confirms_edits(const std::string& core) = 0;
  /// Why the call may not do that with `service`, as the error that answers it; nothing: it may. Requires an effect
  /// that moves().
  virtual std::optional<Value> refuse(const Caller& caller, const std::string& service, rsm::CallEffect effect) = 0;
  /// `core` is over, and makes no call of `service` any more.
  virtual void release(const std::string& core, const std::string& service) = 0;
};

/// Lets everything pass: of a run that has its cell for itself (`race run`).
class OpenGate final : public MotionGate {
 public:
  Expected<std::uint64_t> begin(const Beginning&) override { return 0; }
  Expected<void> may_force(const Beginning&) override { return {}; }
  bool confirms_edits(const std::string&) override { return false; }
  std::optional<Value> refuse(const Caller&, const std::string&, rsm::CallEffect) override { return std::nullopt; }
  void release(const std::string&, const std::string&) override {}
};

}  // namespace race::services
