// The contexts of thesis 3.4.1 as values: Δ (the present state of the model) and Σ (the snapshot of its environment),
// and what lies below the rules to make them fast: lists of active children, and the work set (work_set.h).
//
// All of it is plain data: copying a RunState copies the run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/semantics/program.h"
#include "core/semantics/state_set.h"

namespace race::semantics {

/// What a state has in Δ besides its values and its flag. The fields that every visit reads stand first, in one cache
/// line.
struct Live {
  // Active children in order of declaration, as a list through `next` and `previous` of the children.
  StateId first_active = kNoState, last_active = kNoState;
  StateId next = kNoState, previous = kNoState;
  bool dirty = false;              // something that its conditions or actions read has changed since its last visit
  bool reevaluating = false;       // it was dirty when the present visit began
  bool touched = false;            // has values that differ from "never active"
  bool recheck = false;            // is dirty again in the next macro step
  std::uint64_t activated_in = 0;  // macro step (epoch) of the last activation, R21
  std::uint64_t activated_at = 0;  // tick of the last activation, R19
  std::uint64_t calls_before = 0;  // calls of the run before the last activation, R20
  std::uint32_t activations = 0;
  std::uint32_t life = 0;         // R26: since which activation it keeps what it has
  PortId left_through = kNoPort;  // R8: by which port it was last left, none: with its parent (R26),
  std::uint32_t left_during = 0;  // in which life of its parent
  std::uint64_t resolved_in = 0;  // transition in which its parameters were resolved, R23

  std::vector<PortId> active_ports;         // of children, with destination: active_ports(Δ,s) of 3.28
  std::vector<PortId> unconnected_ports;    // active ones of children, without destination
  std::vector<BarrierId> active_barriers;   // active_barriers(Δ,s) of 3.29
  std::vector<BarrierId> partial_barriers;  // inactive child barriers with arrivals
  std::vector<StateId> touched_children;
};

/// The response of one caller's latest call of one operation (R6, R20).
struct CallRecord {
  StateId caller = kNoState;
  std::string service;  // whose, if the operation is an open one (language::ServiceTable); else empty
  std::uint64_t number = 0;
  bool answered = false, is_error = false;
  Value response = Value::unknown();
  bool operator==(const CallRecord&) const = default;
};

/// A call that leaves the run (FuncSC). Without caller: made because the run ended, not by code.
///
/// `supersedes`: the number of the caller's earlier call of the operation that was open and cannot be answered any more
/// (R20), for those who carry calls out; 0: none. It follows from the calls before it, so no trace has it.
struct OutgoingCall {
  std::uint64_t number = 0;
  OperationId operation = kNone;
  std::string service, name;
  List args;
  Dict kwargs;
  StateId caller = kNoState;
  std::uint64_t supersedes = 0;
  bool operator==(const OutgoingCall&) const = default;
};

/// One input (core/SEMANTICS.md section 3).
struct Input {
  enum class Kind : std::uint8_t { event, response } kind = Kind::event;
  std::uint32_t number = kNone;  // EventId or OperationId
  std::uint64_t call = 0;        // of a response
  bool is_error = false;
  Value data;

  /// An occurrence of `event`.
  static Input occurrence(EventId event, Value data) { return {Kind::event, event, 0, false, std::move(data)}; }
};

/// Δ and Σ. Stamps count epochs (macro steps with an input) and ticks (deliveries, activations,
/// executions).
struct RunState {
  explicit RunState(const Program& program);

  // Δ
  std::vector<Value> values;            // Π, Ξ, Λ by ValueIndex
  std::vector<std::uint8_t> flags;      // Φ by Flag
  std::vector<std::uint8_t> arrived;    // activated(b), by inbound port
  std::vector<Live> live;               // by StateId
  std::vector<std::uint32_t> arrivals;  // how many of the inbound ports have arrived, by BarrierId
  // OPTIMIZATION: the states that have work: dirty, or with active ports or barriers of children. Any other active
  // state would take an SProp without effect.
  StateSet work_set;
  std::uint32_t active_states = 0;
  std::vector<std::uint32_t> value_units;  // of the strings, lists and dicts in `values`; 0 of all else
  std::uint64_t data_units = 0;            // their sum
  bool small_budget = false;               // even a short condition may exceed it: all are evaluated

  // Σ
  std::uint64_t epoch = 1;  // the present macro step
  std::uint64_t tick = 1;
  std::uint64_t transitions = 0;                         // PTrans1 and barriers of PTrans2
  EventId occurrence = kNone;                            // of this macro step
  std::vector<Value> event_data;                         // newest ever delivered, by EventId
  std::vector<std::uint64_t> event_tick, response_tick;  // last delivery
  std::vector<std::uint64_t> executed;                   // epoch, by ActionId
  std::vector<std::uint64_t> served;                     // tick of the last execution, by ActionId; 0 = may run (R19)
  std::vector<std::uint64_t> triggered;                  // epoch, by PortId (R9)
  std::vector<std::vector<CallRecord>> calls;            // by OperationId, latest last
  std::uint64_t call_count = 0;
  PortId forced = kNoPort;  // of this macro step (R24)

  std::vector<StateId> recheck;              // states that are dirty again in the next macro step
  bool started = false;                      // the root has been activated
  std::vector<std::string> services_called;  // in order of first call
};

/// Everything in Δ as never active, for a state that is entered (R8): results and variables of `s` initial, parameters
/// too of its descendants. `log` takes the old values.
using ValueLog = std::vector<std::pair<ValueIndex, Value>>;
void reset_values(RunState& run, const Program& program, StateId s, ValueLog& log);

/// Counts the strings, lists and dicts that the changes in `log` have put in place of others. `changed`: for its own
/// use.
void count_data(RunState& run, const ValueLog& log, std::vector<ValueIndex>& changed);
/// OPTIMIZATION: whether there are any; most changes are of numbers.
inline bool changes_data(const RunState& run, const ValueLog& log) {
  for (const auto& [at, before] : log)
    if (holds_data(before) || holds_data(run.values[at])) return true;
  return false;
}

/// Fills in what follows from Φ, the values and the arrivals that stand in `run`: its lists and counts. Every active
/// state is in the work set, to be evaluated anew: with unchanged data that has no effect. Requires that the run is
/// between macro steps, that lists and counts are those of a new run, and that what is active has an active parent.
void fill_lists(RunState& run, const Program& program);

}  // namespace race::semantics
