// Derivations as values: small nodes in pre-order, each with the size of its subtree, in one arena for a macro step.
// recorder.h writes them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/semantics/context.h"
#include "core/semantics/program.h"
#include "core/semantics/rules.h"

namespace race::semantics {

/// The truth of a node's conclusion, where it has one.
enum class NodeValue : std::uint8_t { none, no, yes, unknown };

enum class FunctionOf : std::uint8_t { none, entry, exit, action };

struct DerivationNode {
  std::uint32_t size = 1;  // of its subtree, itself included
  Flag at = 0;             // the state or barrier that the conclusion is about
  PortId port = kNoPort;
  std::uint32_t action = kNone;  // from 0, within the state
  std::uint32_t detail = kNone;  // Resolve: into `resolved`; FuncSC: into `calls`
  std::uint32_t required = 0;    // service data that Cond or Func read: `required_count` entries from here
  std::uint16_t required_count = 0;
  Rule rule = Rule::Micro;
  Refinement refinement = 0;
  NodeValue value = NodeValue::none;
  FunctionOf of = FunctionOf::none;
  bool operator==(const DerivationNode&) const = default;
};

struct Resolved {
  std::uint32_t parameter = 0;  // number within the state
  Value value;
  bool operator==(const Resolved&) const = default;
};

struct RequiredDatum {
  enum class Kind : std::uint8_t { event, result, error } kind;
  std::uint32_t number;
  std::string service;  // whose, if it is an open operation; else empty
  bool operator==(const RequiredDatum&) const = default;
};

/// The derivations of the micro steps of one macro step.
struct Derivation {
  std::vector<DerivationNode> nodes;
  std::vector<Resolved> resolved;
  std::vector<OutgoingCall> calls;
  std::vector<RequiredDatum> required;
  std::vector<std::uint32_t> micro;  // where the tree of each micro step begins
  /// Empties it and keeps its memory.
  void clear();
  bool operator==(const Derivation&) const = default;
};

/// The tree of micro step `number`, in the shape of core/SEMANTICS.md section 7.
Value derivation_json(const Program& program, const Derivation& derivation, std::size_t number);

}  // namespace race::semantics
