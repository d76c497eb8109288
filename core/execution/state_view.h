// StateView: what watchers have been shown of a run, and what has changed since (schemas/core_delta.json).
#pragma once

#include <cstdint>
#include <vector>

#include "core/semantics/run.h"
#include "core/value/value.h"

namespace race::execution {

class StateView {
 public:
  /// The whole state (schemas/state.json); from now on, changes count from here.
  Value snapshot(const semantics::Run& run);
  /// Notes the ports that have fired: to be called after each micro step.
  void note_fired_ports(const semantics::Run& run);
  /// active, ports, activated, parameters, results, variables, unset, fired: what has changed since the last snapshot
  /// or delta.
  Dict delta(const semantics::Run& run);

 private:
  void remember(const semantics::Run& run);
  void add_flags(const semantics::Run& run, Dict& out) const;
  void add_arrivals(const semantics::Run& run, Dict& out) const;
  void add_values(const semantics::Run& run, Dict& out) const;

  std::vector<std::uint8_t> flags_, arrived_;
  std::vector<Value> values_;
  std::vector<std::uint8_t> ports_;  // flags of the ports at the last look
  List fired_;
};

}  // namespace race::execution
