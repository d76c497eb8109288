// Program: a native model, compiled. Flat arrays; states, barriers and ports by number in tree order; conditions and
// functions compiled with what they read. Immutable: any number of runs on any threads share one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/compile/code.h"
#include "core/language/interface/service_table.h"
#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/semantics/program_ids.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::semantics {

/// Whether a value counts in the data of a run (Budgets::data_units): a string, list or dict.
inline bool holds_data(const Value& v) { return v.kind() >= Value::Kind::string; }
/// What it counts.
inline std::uint32_t data_units(const Value& v) {
  return holds_data(v) ? static_cast<std::uint32_t>(v.size_units()) : 0;
}

enum class StateId : std::uint32_t {};
enum class BarrierId : std::uint32_t {};
enum class PortId : std::uint32_t {};
using ActionId = std::uint32_t;
using language::Code;
using language::EventId;
using language::Flag;
using language::kNone;
using language::OperationId;
using language::ValueIndex;

template <typename Id>
constexpr std::uint32_t index(Id id) {
  return static_cast<std::uint32_t>(id);
}
inline constexpr StateId kNoState{kNone};
inline constexpr PortId kNoPort{kNone};

/// Half-open range of numbers.
template <typename Id>
struct Range {
  std::uint32_t low = 0, high = 0;
  std::uint32_t size() const { return high - low; }
  struct Iterator {
    std::uint32_t at;
    Id operator*() const { return Id{at}; }
    Iterator& operator++() {
      ++at;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  friend Iterator begin(Range r) { return {r.low}; }
  friend Iterator end(Range r) { return {r.high}; }
};

/// A child: a state or a barrier.
struct NodeRef {
  bool barrier = false;
  std::uint32_t number = kNone;
  explicit operator bool() const { return number != kNone; }
  StateId state() const { return StateId{number}; }
  BarrierId as_barrier() const { return BarrierId{number}; }
};

struct ParameterInfo {
  std::string name;
  std::optional<Value> value;
  Code from;
};

struct ActionInfo {
  Code when, code;
  bool served = false;          // R19 applies: it contains svc, not only through `.latest`
  bool level = false;           // its condition mentions no datum that is delivered
  std::vector<EventId> events;  // a new one lets it run again (R19)
  std::vector<OperationId> responses;
};

struct PortInfo {
  StateId state = kNoState;
  bool svc = false;  // its condition mentions svc: R9 applies
  NodeRef to;
  Code when;
  std::string name;
};

struct BarrierInfo {
  std::string name, path;
  StateId parent = kNoState;
  std::vector<StateId> to;
  std::vector<PortId> in;  // all sibling ports that lead here, in order
};

struct StateInfo {
  StateId parent = kNoState;
  std::uint32_t end = 0;  // its descendants are the states (own number, end)
  Range<PortId> ports;
  Range<ActionId> actions;
  std::uint64_t own_mask = 0;  // service data that its conditions and actions read, as bits of a small filter
  std::uint64_t subtree_mask = 0;
  bool needs_occurrence = false;          // no actions, and no port can fire without an occurrence
  bool stateless = false;                 // nothing that R8 could reset: no results, variables or child states
  bool read_by_parent = false;            // its parent reads a parameter or result of it
  bool keeps = false, keeps_any = false;  // R8
  bool keeps_deep = false;                // R26
  NodeRef first;
  Code entry, exit;
  ValueIndex first_parameter = 0, first_result = 0, first_variable = 0;
  std::vector<ParameterInfo> parameters;  // slots from `first_parameter` on; likewise below
  std::vector<std::string> results, variables;
  std::vector<NodeRef> children;
  std::vector<PortId> keep_ports;
  std::vector<OperationId> calls;  // by code of it or a descendant (R20)
  std::string name, path;
};

/// Whose conditions and actions read a place in Δ: the state that it belongs to, or that state's parent.
enum Reader : std::uint8_t { kNoReader = 0, kOwner = 1, kParent = 2 };

class Program {
 public:
  /// Compiles a native model against the services that are known: key after `svc.` -> description. Errors: those of
  /// language::check, with the path of the state, as a document without violations has none.
  static Checked<std::shared_ptr<const Program>> build(const rcm::NativeModel& model,
                                                       const std::map<std::string, rsm::Service>& services);

  const StateInfo& operator[](StateId s) const { return states[index(s)]; }
  const BarrierInfo& operator[](BarrierId b) const { return barriers[index(b)]; }
  const PortInfo& operator[](PortId p) const { return ports[index(p)]; }

  Flag flag(StateId s) const { return index(s); }
  Flag flag(BarrierId b) const { return first_barrier_flag + index(b); }
  Flag flag(PortId p) const { return first_port_flag + index(p); }
  Flag flag(NodeRef x) const { return x.barrier ? flag(x.as_barrier()) : flag(x.state()); }
  std::size_t flag_count() const { return states.size() + barriers.size() + ports.size(); }

  /// `Root/A.success`
  std::string address(PortId p) const { return states[index((*this)[p].state)].path + "." + (*this)[p].name; }
  /// The path of the node with this flag. Requires the flag of a state or barrier.
  const std::string& node_path(Flag flag) const {
    return flag < states.size() ? states[flag].path : barriers[flag - states.size()].path;
  }
  std::optional<StateId> find_state(std::string_view path) const;
  std::optional<PortId> find_port(std::string_view address) const;

  /// The state or port with this id (rcm `meta.id`), the first if the document repeats it; in logarithmic time.
  std::optional<StateId> state_with_id(std::string_view id) const;
  std::optional<PortId> port_with_id(std::string_view id) const;

  const std::string& id(StateId s) const { return ids.states[index(s)]; }
  const std::string& id(BarrierId b) const { return ids.barriers[index(b)]; }
  const std::string& id(PortId p) const { return ids.ports[index(p)]; }

  /// Whether code names the event, or reads a response of the operation: only then it is an input (section 3).
  bool names_event(EventId e) const { return e < event_named.size() && event_named[e]; }
  bool names_response(OperationId o) const { return o < response_named.size() && response_named[o]; }

  static std::uint64_t event_bit(EventId e) { return std::uint64_t{1} << (e * 0x9E3779B1U >> 26); }
  static std::uint64_t response_bit(OperationId o) { return std::uint64_t{1} << (~o * 0x85EBCA6BU >> 26); }

  static constexpr StateId root{0};
  std::vector<StateInfo> states;  // in tree order; the root is 0
  Flag first_barrier_flag = 0, first_port_flag = 0;
  std::vector<BarrierInfo> barriers;
  std::vector<PortInfo> ports;  // of one state together, siblings in order
  std::vector<ActionInfo> actions;
  std::vector<Value> initial;                             // by ValueIndex; unknown = has no value
  std::vector<std::uint32_t> initial_units;               // data_units() of each
  std::vector<std::uint8_t> value_readers, flag_readers;  // Reader bits
  std::vector<StateId> value_owner;                       // whose parameter, result or variable it is
  language::ServiceTable services;
  std::vector<std::uint8_t> sampled;  // by EventId
  std::vector<std::uint8_t> event_named, response_named;
  // The states whose conditions and actions read the event, or a response of the operation, in order.
  std::vector<std::vector<StateId>> event_readers, response_readers;
  ProgramIds ids;
};

}  // namespace race::semantics
