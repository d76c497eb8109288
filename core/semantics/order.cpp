#include "core/semantics/order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace race::semantics {
namespace {

using Positions = std::vector<std::uint32_t>;

Positions declared_positions(std::size_t size) {
  Positions positions(size);
  std::iota(positions.begin(), positions.end(), 0U);
  return positions;
}

Order::OfState declared_lists(const Program& program, StateId s) {
  const StateInfo& state = program[s];
  return {s, declared_positions(state.ports.size()), declared_positions(state.actions.size()),
          declared_positions(state.children.size())};
}

std::vector<Order::OfState> declared_lists(const Program& program) {
  std::vector<Order::OfState> states;
  for (std::uint32_t s = 0; s < program.states.size(); ++s) states.push_back(declared_lists(program, StateId{s}));
  return states;
}

/// Pseudo-random numbers by splitmix64 (Steele, Lea, Flood 2014): the standard library's shuffle and distributions
/// differ among platforms.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

// Fisher and Yates. Of lists as short as these, the remainder is no less uniform than anyone could see.
void shuffle(Positions& positions, SplitMix64& random) {
  for (std::size_t left = positions.size(); left > 1; --left)
    std::swap(positions[left - 1], positions[random.next() % left]);
}

/// Takes over `given`, if it is a permutation of `positions`, which are the declared ones.
bool take_over(Positions& positions, const Positions& given) {
  if (given.empty()) return true;
  if (given.size() != positions.size() || !std::ranges::is_permutation(given, positions)) return false;
  positions = given;
  return true;
}

}  // namespace

Order Order::reversed(const Program& program) {
  std::vector<OfState> states = declared_lists(program);
  for (OfState& state : states)
    for (Positions* list : {&state.ports, &state.actions, &state.children}) std::ranges::reverse(*list);
  return make(program, states);
}

Order Order::random(const Program& program, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<OfState> states = declared_lists(program);
  for (OfState& state : states)
    for (Positions* list : {&state.ports, &state.actions, &state.children}) shuffle(*list, random);
  return make(program, states);
}

Expected<Order> Order::of(const Program& program, const std::vector<OfState>& states) {
  std::vector<OfState> every_state = declared_lists(program);
  std::vector<bool> named(every_state.size(), false);
  for (const OfState& given : states) {
    const std::uint32_t s = index(given.state);
    if (s >= every_state.size())
      return tl::unexpected(Error{ErrorCode::out_of_range, "the model has no state " + std::to_string(s)});
    const std::string& path = program[given.state].path;
    if (named[s]) return tl::unexpected(Error{ErrorCode::duplicate, "the order names this state twice", path});
    named[s] = true;
    OfState& state = every_state[s];
    if (!take_over(state.ports, given.ports) || !take_over(state.actions, given.actions) ||
        !take_over(state.children, given.children))
      return tl::unexpected(
          Error{ErrorCode::out_of_range, "an order must name each position of its list once, from 0", path});
  }
  return make(program, every_state);
}

Order Order::make(const Program& program, const std::vector<OfState>& every_state) {
  Lists lists = list(program, every_state);
  place(program, lists);
  Order order;
  order.lists_ = std::make_shared<const Lists>(std::move(lists));
  return order;
}

Order::Lists Order::list(const Program& program, const std::vector<OfState>& every_state) {
  Lists lists;
  for (const OfState& of_state : every_state) {
    const StateInfo& state = program[of_state.state];
    lists.first_child.push_back(static_cast<std::uint32_t>(lists.children.size()));
    for (const std::uint32_t position : of_state.ports) lists.ports.push_back(PortId{state.ports.low + position});
    for (const std::uint32_t position : of_state.actions) lists.actions.push_back(state.actions.low + position);
    for (const std::uint32_t position : of_state.children) lists.children.push_back(state.children[position]);
  }
  return lists;
}

void Order::place(const Program& program, Lists& lists) {
  lists.port_place.resize(program.ports.size());
  lists.barrier_place.resize(program.barriers.size());
  std::uint32_t place = 0;
  for (const NodeRef node : lists.children) {
    if (node.barrier) {
      lists.barrier_place[node.number] = place++;
      continue;
    }
    const Range<PortId> ports = program[node.state()].ports;
    for (std::uint32_t at = ports.low; at < ports.high; ++at) lists.port_place[index(lists.ports[at])] = place++;
  }
  for (const BarrierInfo& barrier : program.barriers) {
    lists.inbound.push_back(barrier.in);
    std::ranges::sort(lists.inbound.back(), {}, [&](PortId p) { return lists.port_place[index(p)]; });
  }
}

bool Order::fits(const Program& program) const {
  return !lists_ ||
         (lists_->ports.size() == program.ports.size() && lists_->actions.size() == program.actions.size() &&
          lists_->first_child.size() == program.states.size() && lists_->inbound.size() == program.barriers.size());
}

void Order::sort(std::vector<PortId>& ports) const {
  if (lists_) std::ranges::sort(ports, {}, [&](PortId p) { return lists_->port_place[index(p)]; });
}

void Order::sort(std::vector<BarrierId>& barriers) const {
  if (lists_) std::ranges::sort(barriers, {}, [&](BarrierId b) { return lists_->barrier_place[index(b)]; });
}

}  // namespace race::semantics
