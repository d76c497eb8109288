// Recorders: what becomes of the rules that a micro step applies. A recorder is a compile-time policy of Step: nothing,
// the names of the rules, or whole trees. The rules read the same for all three.
#pragma once

#include <concepts>
#include <vector>

#include "core/language/interface/environment.h"
#include "core/semantics/derivation.h"

namespace race::semantics {

/// Told when a rule comes to a port, an action or a parameter, before it is evaluated: also of those that become no
/// premise of any rule, and in a micro step that is discarded.
class TurnWatch {
 public:
  TurnWatch() = default;
  virtual ~TurnWatch() = default;
  TurnWatch(const TurnWatch&) = delete;
  TurnWatch& operator=(const TurnWatch&) = delete;
  virtual void port(PortId) {}
  /// Of the program.
  virtual void action(ActionId) {}
  /// By its number within the state.
  virtual void parameter(StateId, std::uint32_t) {}
};

/// What a rule says about its node, where nodes are not kept.
struct [[maybe_unused]] NoNode {
  void refinement(Refinement) {}
  void value(language::Truth) {}
  void of(FunctionOf) {}
  void resolved(std::uint32_t, const Value&) {}
  void required(const std::vector<RequiredDatum>&) {}
};

/// See TreeRecorder::Postponed, where nodes are not kept.
struct [[maybe_unused]] NothingPostponed {
  void insert(Flag) {}
};

/// Records nothing and costs nothing.
struct NoRecorder {
  static constexpr bool kVisitsAll = false;
  static constexpr bool kReevaluatesAll = false;
  static constexpr bool kTraces = false;
  struct [[maybe_unused]] Mark {};

  NoNode open(Rule, Flag, PortId = kNoPort, std::uint32_t = kNone) { return {}; }
  void add(Rule, Flag, PortId, bool) {}
  void add_part(Rule, Flag, language::Truth) {}
  void add_part(Rule, Flag) {}
  void add_call(Flag, const OutgoingCall&) {}
  void turn(PortId) {}
  void turn(ActionId) {}
  void turn(StateId, std::uint32_t) {}
  Mark mark() const { return {}; }
  void discard(Mark) {}
  NothingPostponed postpone(Mark) { return {}; }
  void complete_micro_step(Mark) {}
};

/// Records the names of the applied rules in pre-order. Leaves nothing out: every micro step evaluates all conditions,
/// so that what the other recorders skip can be tested against it.
struct NameRecorder {
  static constexpr bool kVisitsAll = true;
  static constexpr bool kReevaluatesAll = true;
  static constexpr bool kTraces = false;
  using Mark = std::size_t;

  NoNode open(Rule rule, Flag, PortId = kNoPort, std::uint32_t = kNone) {
    names.push_back(rule);
    return {};
  }
  void add(Rule rule, Flag, PortId, bool) { names.push_back(rule); }
  void add_part(Rule, Flag, language::Truth) {}
  void add_part(Rule, Flag) {}
  void add_call(Flag, const OutgoingCall&) {}
  void turn(PortId) {}
  void turn(ActionId) {}
  void turn(StateId, std::uint32_t) {}
  Mark mark() const { return names.size(); }
  void discard(Mark mark) { names.resize(mark); }
  NothingPostponed postpone(Mark) { return {}; }
  void complete_micro_step(Mark mark) { micro.push_back(static_cast<std::uint32_t>(mark)); }

  std::vector<Rule> names;
  std::vector<std::uint32_t> micro;  // where each micro step begins
};

/// Records whole trees.
struct TreeRecorder {
  static constexpr bool kVisitsAll = true;
  static constexpr bool kReevaluatesAll = false;
  static constexpr bool kTraces = true;
  using Mark = std::size_t;
  class Node;
  class Postponed;

  /// Opens a node: what is recorded until it goes out of scope are its premises. `action`: its number within the state.
  Node open(Rule rule, Flag at, PortId port = kNoPort, std::uint32_t action = kNone);
  /// A rule without premises that concludes whether something holds.
  void add(Rule rule, Flag at, PortId port, bool holds);
  /// A part of a condition, with its value, or a statement of a function. Trees alone show them.
  void add_part(Rule rule, Flag at, language::Truth value);
  void add_part(Rule rule, Flag at);
  /// A statement that called an operation.
  void add_call(Flag at, const OutgoingCall& call);
  /// The condition of a port is evaluated next. No node: that it does not hold is no premise of any rule.
  void turn(PortId p) {
    if (watch) watch->port(p);
  }
  /// It is the turn of an action.
  void turn(ActionId a) {
    if (watch) watch->action(a);
  }
  /// A parameter of `s` is resolved next.
  void turn(StateId s, std::uint32_t parameter) {
    if (watch) watch->parameter(s, parameter);
  }

  Mark mark() const { return derivation.nodes.size(); }
  /// Takes back what was recorded since `mark`: of an attempt that became no rule. Requires that it is closed.
  void discard(Mark mark) { derivation.nodes.resize(mark); }
  /// Takes out the nodes since `mark`, to be inserted later.
  Postponed postpone(Mark mark);
  /// What was recorded since `mark` is the tree of a micro step.
  void complete_micro_step(Mark mark) { derivation.micro.push_back(static_cast<std::uint32_t>(mark)); }

  Derivation derivation;
  /// Not owned, and may be null.
  TurnWatch* watch = nullptr;
};

/// A node while its premises are recorded: it closes (its size is known) when this goes out of scope.
class TreeRecorder::Node {
 public:
  Node(Derivation& derivation, DerivationNode node) : derivation_(derivation), number_(derivation.nodes.size()) {
    derivation_.nodes.push_back(node);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node() { node().size = static_cast<std::uint32_t>(derivation_.nodes.size() - number_); }

  void refinement(Refinement refinement) { node().refinement = refinement; }
  void value(language::Truth truth);
  void of(FunctionOf of) { node().of = of; }
  /// Of Resolve: the value of a parameter, by its number within the state.
  void resolved(std::uint32_t parameter, const Value& value);
  /// The service data that a condition or function has read.
  void required(const std::vector<RequiredDatum>& data);

 private:
  DerivationNode& node() { return derivation_.nodes[number_]; }
  Derivation& derivation_;
  std::size_t number_ = 0;
};

/// Nodes without premises that stand in the tree later than they were evaluated (R23).
class TreeRecorder::Postponed {
 public:
  Postponed(Derivation& derivation, Mark mark);
  /// Puts those about `at` into the derivation.
  void insert(Flag at);

 private:
  Derivation& derivation_;
  std::vector<DerivationNode> nodes_;
};

inline TreeRecorder::Node TreeRecorder::open(Rule rule, Flag at, PortId port, std::uint32_t action) {
  return {derivation, {.at = at, .port = port, .action = action, .rule = rule}};
}

inline TreeRecorder::Postponed TreeRecorder::postpone(Mark mark) { return {derivation, mark}; }

inline void TreeRecorder::add(Rule rule, Flag at, PortId port, bool holds) {
  DerivationNode& node = derivation.nodes.emplace_back();
  node.at = at;
  node.port = port;
  node.rule = rule;
  node.value = holds ? NodeValue::yes : NodeValue::no;
}

/// kVisitsAll: every active state is visited, as SProp (3.30) says, else those of the work set. kReevaluatesAll: also
/// conditions of which nothing has changed are evaluated. kTraces: the interpreter says which parts it evaluated.
template <typename R>
concept Recorder = requires {
  { R::kVisitsAll } -> std::convertible_to<bool>;
  { R::kReevaluatesAll } -> std::convertible_to<bool>;
  { R::kTraces } -> std::convertible_to<bool>;
};

/// Those with which a step can take another order than the declared one: the work set is in declared order.
template <typename R>
concept VisitsAll = Recorder<R> && R::kVisitsAll;

}  // namespace race::semantics
