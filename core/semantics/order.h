// Order: in which order a step comes to the ports, actions and children of each state. It is what "in order" means in
// core/SEMANTICS.md section 4. Runs use the declared order; exploration and a debugger also use others, to show whether
// a model depends on it.
//
// A value that never changes, for the states of one Program; copies share its lists. Any threads may read it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

/// Ports or actions of one state, in the order of a step.
template <typename Id>
struct OrderedRange {
  struct Iterator {
    const Id* listed;  // by number; null: in declared order
    std::uint32_t at;
    Id operator*() const { return listed ? listed[at] : Id{at}; }
    Iterator& operator++() {
      ++at;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Range<Id> declared;
  const Id* listed;
  Iterator begin() const { return {listed, declared.low}; }
  Iterator end() const { return {listed, declared.high}; }
};

class Order {
 public:
  /// The lists of one state in another order: each names its declared positions (from 0), the first one first. An empty
  /// list stands for the declared order.
  struct OfState {
    StateId state = kNoState;
    std::vector<std::uint32_t> ports, actions, children;
  };

  /// The declared order, of any program.
  static const Order& declared() { return kDeclared; }
  /// Every list from its last element to its first.
  static Order reversed(const Program& program);
  /// Every list in an order that depends on `seed` and the lengths of the lists alone, on every platform.
  static Order random(const Program& program, std::uint64_t seed);
  /// As `states` says; the lists of other states stay as they are declared. Errors: `out_of_range` for a state that
  /// `program` does not have and for a list that is not a permutation, `duplicate` for a state that is named twice.
  static Expected<Order> of(const Program& program, const std::vector<OfState>& states);

  bool is_declared() const { return !lists_; }
  /// Whether it is an order of `program`, as far as the numbers of its elements tell. Below, this is required.
  bool fits(const Program& program) const;

  OrderedRange<PortId> ports(const Program& program, StateId s) const {
    return {program[s].ports, lists_ ? lists_->ports.data() : nullptr};
  }
  OrderedRange<ActionId> actions(const Program& program, StateId s) const {
    return {program[s].actions, lists_ ? lists_->actions.data() : nullptr};
  }
  std::span<const NodeRef> children(const Program& program, StateId s) const {
    const std::vector<NodeRef>& declared = program[s].children;
    if (!lists_) return declared;
    return {lists_->children.data() + lists_->first_child[index(s)], declared.size()};
  }
  /// in(b): children in order, and ports in order.
  std::span<const PortId> inbound(const Program& program, BarrierId b) const {
    return lists_ ? lists_->inbound[index(b)] : program[b].in;
  }
  /// Brings ports or barriers of siblings from the declared order to this one: children in order, and ports in order.
  void sort(std::vector<PortId>& ports) const;
  void sort(std::vector<BarrierId>& barriers) const;

 private:
  constexpr Order() = default;
  struct Lists {
    std::vector<PortId> ports;  // of each state there where its declared ones are numbered
    std::vector<ActionId> actions;
    std::vector<NodeRef> children;  // of each state from `first_child` on
    std::vector<std::uint32_t> first_child;
    std::vector<std::uint32_t> port_place, barrier_place;  // among the ports and barriers of the siblings
    std::vector<std::vector<PortId>> inbound;
  };
  static Lists list(const Program& program, const std::vector<OfState>& every_state);
  static void place(const Program& program, Lists& lists);
  static Order make(const Program& program, const std::vector<OfState>& every_state);

  static const Order kDeclared;
  std::shared_ptr<const Lists> lists_;  // held by every copy of the order; null: declared
};

inline constinit const Order Order::kDeclared;

}  // namespace race::semantics
