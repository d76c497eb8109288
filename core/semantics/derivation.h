// Derivations as values: small nodes in pre-order, each with the size of its subtree, in one arena for a macro step;
// and the three recorders that decide at compile time what a node is: nothing, a name, a node of a tree.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/language/interface/environment.h"
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

/// What one evaluation touched, until its Cond or Func becomes a node.
class EvaluationRecord final : public language::EvaluationTrace {
 public:
  struct Part {
    Rule rule;  // CondBE, CondBD, FuncST, FuncSD, FuncSC
    NodeValue value;
    std::uint32_t call;  // FuncSC
  };
  void clear() {
    parts.clear();
    required.clear();
  }
  void atom(bool service, language::Truth value, SourceRange) override;
  void statement(bool service, SourceRange) override;
  void required_event(EventId event) override { require({RequiredDatum::Kind::event, event, {}}); }
  void required_response(OperationId operation, std::string_view service, bool error) override {
    require({error ? RequiredDatum::Kind::error : RequiredDatum::Kind::result, operation, std::string(service)});
  }
  std::vector<Part> parts;
  std::vector<RequiredDatum> required;

 private:
  void require(RequiredDatum datum);
};

NodeValue node_value(language::Truth truth);

/// Records nothing and costs nothing.
struct NoRecorder {
  static constexpr bool kRecords = false;
  static constexpr bool kTree = false;
  static constexpr bool kLooksAgain = false;
};

/// Records the names of the applied rules in pre-order. Leaves nothing out: every micro step looks at all conditions,
/// so that what the others skip can be tested against it.
struct NameRecorder {
  static constexpr bool kRecords = true;
  static constexpr bool kTree = false;
  static constexpr bool kLooksAgain = true;
  std::vector<Rule> names;
  std::vector<std::uint32_t> micro;  // where each micro step begins
};

/// Records whole trees.
struct TreeRecorder {
  static constexpr bool kRecords = true;
  static constexpr bool kTree = true;
  static constexpr bool kLooksAgain = false;
  Derivation derivation;
  EvaluationRecord evaluation;
};

template <typename R>
concept Recorder = requires {
  { R::kRecords } -> std::convertible_to<bool>;
  { R::kTree } -> std::convertible_to<bool>;
  { R::kLooksAgain } -> std::convertible_to<bool>;  // at conditions of which nothing has changed
};

/// A node while its premises are recorded: it closes (its size is known) when this goes out of scope. Without a tree it
/// is empty.
template <Recorder R>
class OpenNode {
 public:
  OpenNode(R& recorder, Rule rule, Flag at, PortId port = kNoPort) {
    if constexpr (R::kTree) {
      recorder_ = &recorder;
      number_ = recorder.derivation.nodes.size();
      recorder.derivation.nodes.push_back({.at = at, .port = port, .rule = rule});
    } else if constexpr (R::kRecords) {
      recorder.names.push_back(rule);
    }
  }
  OpenNode(const OpenNode&) = delete;
  OpenNode& operator=(const OpenNode&) = delete;
  ~OpenNode() {
    if constexpr (R::kTree) node().size = static_cast<std::uint32_t>(recorder_->derivation.nodes.size() - number_);
  }
  /// Requires a tree.
  DerivationNode& node() { return recorder_->derivation.nodes[number_]; }
  OpenNode& refinement(Refinement r) {
    if constexpr (R::kTree) node().refinement = r;
    return *this;
  }

 private:
  R* recorder_ = nullptr;
  std::size_t number_ = 0;
};

}  // namespace race::semantics
