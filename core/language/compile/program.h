// Program: the compiled form of a code, used in core/language alone. A tree of small nodes in one array; a node refers
// to its parts by number. Names are places, constants are frozen, and nothing in it changes after compiling.
#pragma once

#include <string>
#include <vector>

#include "core/language/compile/code.h"
#include "core/language/compile/opcode.h"
#include "core/language/library/functions.h"
#include "core/language/syntax/source.h"
#include "core/value/value.h"

namespace race::language {

using NodeId = std::uint32_t;

enum class DynamicRead : std::uint8_t { data, present, latest };

struct Node {
  Opcode op = Opcode::pass;
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
  std::vector<std::pair<std::uint32_t, ValueIndex>> entries;
};

struct MethodCall {
  const Method* method = nullptr;
  std::uint32_t place = kNone;  // of Opcode::mutate
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

/// A condition `datum op bound` or `datum.key op bound`; `datum` is Opcode::pass for conditions of any other form.
struct Comparison {
  static constexpr std::uint64_t kUnits = 4;  // of the budget
  Opcode datum = Opcode::pass;                // event, event_latest or slot,
  Opcode op = Opcode::pass;
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
