// Program: the compiled form of a code, internal to this room. A tree of small nodes in one array; a node names its
// parts by number. Names are places, constants are frozen, and nothing in it changes after compiling.
#pragma once

#include <string>
#include <vector>

#include "core/language/code.h"
#include "core/language/functions.h"
#include "core/language/source.h"
#include "core/value/value.h"

namespace race::language {

using NodeId = std::uint32_t;

/// What a node computes or does. Letters in comments are its fields; "[a, count]" is a run of `Program::runs`.
enum class Op : std::uint8_t {
  // Leaves: a = number of the constant, local, slot, flag, event or operation.
  constant,
  local,
  slot,
  flag,
  event,          // data of the occurrence, or of the newest sample
  event_present,  // in a boolean position: true or unknown
  event_latest,
  response,  // b = 1: the error
  response_present,
  dynamic_event,     // a = service, b = constant with the event's name, c = a DynamicRead
  dynamic_response,  // a = service, b = constant with the operation's name, c = 1: the error, 2: presence (bits)
  collection,        // a = number of the collection
  // Operators.
  field,  // a . constant b
  index,  // a [b]
  slice,  // run of object, low, high, step; kNone where one is missing
  negative,
  positive,
  logical_not,
  add,
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  in,
  not_in,
  is_none,
  is_not_none,
  chain,          // run of operand, operator, operand, operator, operand ...; the operators are Ops
  logical_and,    // run
  logical_or,     // run
  conditional,    // a if b then, c else
  list,           // run
  dict,           // run of key, value, ...
  comprehension,  // a = element, b = number of the comprehension
  fstring,        // run
  format,         // a printed after conversion c to format b (kNone: none)
  available,      // a
  function,       // b = number of the call, run of arguments, kNone where one is not given
  method,         // b = number of the method call, run of object and arguments
  change,         // b = number of the method call, run of arguments; changes a place
  change_value,   // b = number of the method call, run of object and arguments; changes a temporary value
  wrong_call,     // run of arguments, then a type fault with the message of constant b
  hold,           // a, copied: what comes after it may change where it stands
  // Statements.
  block,          // run
  evaluate,       // a
  assign_local,   // a to local b
  assign_slot,    // a to slot b
  assign,         // a to the targets of a run
  augment_local,  // local a, Op c, value b
  augment_slot,
  augment_place,  // a = number of the place
  branch,         // run of test, block, test, block, ..., [block]
  loop,           // for target a in b: block c
  repeat,         // while a: block b
  stop,
  skip,
  pass,
  call_service,  // a = number of the service call
  // Targets.
  target_local,   // a
  target_slot,    // a
  target_place,   // a = number of the place
  target_unpack,  // run of targets
};

enum class DynamicRead : std::uint8_t { data, present, latest };

struct Node {
  Op op = Op::pass;
  bool service = false;  // reads or calls a service, in it or in a part of it
  std::uint16_t count = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
};
static_assert(sizeof(Node) == 16);

/// A value that can be changed in place: a local or a slot, and steps into it.
struct Place {
  struct Step {
    NodeId key = kNone;           // evaluated each time ...
    std::uint32_t field = kNone;  // ... or a constant, for `.name`
  };
  bool local = true;
  std::uint32_t root = 0;  // local or slot
  std::vector<Step> steps;
};

/// par, res or var as a whole: its names (constants) with their slots, in the order of the names.
struct Collection {
  std::vector<std::pair<std::uint32_t, Slot>> entries;
};

struct MethodCall {
  const Method* method = nullptr;
  std::uint32_t place = kNone;  // of Op::change
};

struct ServiceCallSite {
  OperationId operation = kNone;
  NodeId service = kNone;                    // of svc[e].op()
  std::uint32_t service_name = 0, name = 0;  // constants; the first if `service` is kNone
  std::vector<NodeId> arguments;
  std::vector<std::pair<std::uint32_t, NodeId>> keywords;  // name (constant), value
};

struct ComprehensionClause {
  NodeId target, iterable;
  std::vector<NodeId> filters;
};

/// A condition `datum op bound` or `datum.key op bound`; `datum` is Op::pass for conditions of any other form.
struct Comparison {
  static constexpr std::uint64_t kUnits = 4;  // of the budget
  Op datum = Op::pass;                        // event, event_latest or slot,
  Op op = Op::pass;
  std::uint32_t number = 0;   // its number
  std::uint32_t key = kNone;  // constant
  std::uint32_t bound = 0;    // constant, an int or float
};

class Program {
 public:
  CodeKind kind = CodeKind::condition;
  std::string text;
  Mentions mentions;
  std::vector<Node> nodes;
  std::vector<Span> spans;  // by node
  std::vector<std::uint32_t> runs;
  std::vector<Value> constants;
  std::vector<Place> places;
  std::vector<Collection> collections;
  std::vector<const Function*> functions;
  std::vector<MethodCall> methods;
  std::vector<ServiceCallSite> calls;
  std::vector<std::vector<ComprehensionClause>> comprehensions;
  std::vector<std::string> locals;  // their names
  NodeId root = 0;
  Comparison comparison;

  const std::uint32_t* run(const Node& n) const { return runs.data() + n.a; }
  SourceRange range(NodeId id) const { return range_of(text, spans[id]); }
};

}  // namespace race::language
