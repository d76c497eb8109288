// Ω of a script: its services, which answer calls by their rules or wait for the script to answer.
#pragma once

#include <string>
#include <vector>

#include "core/execution/execution.h"
#include "core/execution/script.h"
#include "core/rsm/rules.h"

namespace race::execution {

class ScriptedServices {
 public:
  /// Both outlive it.
  ScriptedServices(const Script& script, Execution& execution);

  /// The handshake of FuncSC (4.14) with Trans1 (4.4).
  void call(const semantics::OutgoingCall& call);
  /// Exec (4.20), its second part: each service takes Trans2 (4.5) as the script says, or Stutter (4.6).
  void step(const ScriptStep& step);

 private:
  bool take_transition(std::size_t service, const ScriptStep& step);
  void reject(const semantics::OutgoingCall& call, const char* code);
  void put(const std::string& service, const rsm::Effect& effect);
  bool waits(const std::string& service, const std::string& event) const;

  const Script& script_;
  Execution& execution_;
  std::vector<rsm::Instance> instances_;  // by service of the script
};

}  // namespace race::execution
