// What a micro step has done, beside the state that it leads to: what goals ask for.
#pragma once

#include <span>

#include "core/semantics/derivation.h"

namespace race::execution {

struct MicroStepFacts {
  bool changed = false;                              // anything: else it ends the macro step
  std::span<const semantics::DerivationNode> nodes;  // of its tree; none if it changed nothing or ended in a fault
  std::span<const semantics::OutgoingCall> calls;    // that it made
  std::span<const semantics::PortId> tested;         // ports whose conditions it evaluated, also if it changed nothing
};

}  // namespace race::execution
