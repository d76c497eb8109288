#include "core/rcm/extent.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "core/rcm/after.h"
#include "core/rcm/constraints.h"
#include "core/rcm/deep_history.h"
#include "core/rcm/oracle.h"

namespace race::rcm {
namespace {

constexpr std::size_t kElement = 16;  // bytes for a parameter, port or action, besides its text

std::size_t bytes_of(const std::optional<std::string>& text) { return text ? text->size() : 0; }

/// The text of the state itself, without its children.
std::size_t bytes_of(const State& state) {
  std::size_t out = kElement + state.name.size() + state.doc.size() + bytes_of(state.entry) + bytes_of(state.exit);
  for (const Parameter& parameter : state.parameters)
    out += kElement + parameter.name.size() + parameter.doc.size() + parameter.unit.size() + bytes_of(parameter.from);
  for (const auto* data : {&state.results, &state.variables}) {
    for (const Datum& datum : *data) out += kElement + datum.name.size() + datum.doc.size() + datum.unit.size();
  }
  for (const Action& action : state.actions) out += kElement + action.when.size() + action.code.size();
  for (const Port& port : state.ports)
    out += kElement + port.name.size() + bytes_of(port.when) + bytes_of(port.after) + bytes_of(port.to);
  return out;
}

std::size_t bytes_of(const Barrier& barrier) {
  std::size_t out = kElement + barrier.name.size();
  for (const std::string& target : barrier.to) out += kElement + target.size();
  return out;
}

std::size_t bytes_of(const std::vector<Node>& nodes) {
  std::size_t out = 0;
  for (const Node& node : nodes) out += std::visit([](const auto& each) { return bytes_of(each); }, node);
  return out;
}

/// What translation adds to a state with this oracle, or with `after` in its ports.
Extent made_by_translation(const State& state, const std::optional<Oracle>& oracle) {
  if (!oracle && std::ranges::none_of(state.ports, [](const Port& port) { return port.after.has_value(); })) return {};
  State bare;  // what translation reads, and of the children their names alone
  bare.first = state.first;
  bare.ports = state.ports;
  bare.oracle = oracle;
  for (const Node& child : state.children) {
    if (std::holds_alternative<Barrier>(child))
      bare.children.push_back(child);
    else
      std::get<State>(bare.children.emplace_back(State())).name = name_of(child);
  }
  const std::size_t children = bare.children.size(), bytes = bytes_of(bare) + bytes_of(bare.children);
  DerivedIds no_ids;
  if (oracle) translate_oracle(bare, no_ids);
  translate_after(bare, no_ids);
  return {bare.children.size() - children, bytes_of(bare) + bytes_of(bare.children) - bytes, 1};
}

class Counter {
 public:
  explicit Counter(const Library& library) : library_(library) {}

  /// `level`: the depth of the recursion; beyond kMaxDepth the result only says that it is too deep. `inside`: the
  /// parent resumes by a deep history.
  Extent count(const State& state, std::size_t level, bool inside) {
    if (level > kMaxDepth) return {1, 0, kMaxDepth + 1};
    if (state.link) {
      const Extent linked = count_linked(*library_.find(*state.link), level + 1, inside);
      return {linked.states, std::min(linked.bytes + bytes_of(state), kMaxBytes + 1), linked.depth + 1};
    }
    const auto oracle = oracle_of(state, inside);
    const Extent made = made_by_translation(state, oracle);
    Extent out{1 + made.states, bytes_of(state) + made.bytes, made.depth};
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      const Extent part =
          inner ? count(*inner, level + 1, is_deep(oracle)) : Extent{1, bytes_of(std::get<Barrier>(child)), 1};
      out.states = std::min(out.states + part.states, kMaxStates + 1);
      out.bytes = std::min(out.bytes + part.bytes, kMaxBytes + 1);
      out.depth = std::max(out.depth, part.depth);
    }
    return {out.states, out.bytes, out.depth + 1};
  }

 private:
  Extent count_linked(const State& state, std::size_t level, bool inside) {
    auto& known = known_[inside ? 1 : 0];
    if (const auto found = known.find(&state); found != known.end()) return found->second;
    const Extent out = count(state, level, inside);
    return known[&state] = out;
  }

  const Library& library_;
  std::array<std::unordered_map<const State*, Extent>, 2> known_;  // outside and inside of deep histories
};

}  // namespace

Extent extent_of(const Document& document, const Library& library) {
  Counter counter(library);
  Extent out = counter.count(document.root, 1, false);
  for (const State& state : document.library) {
    const Extent one = counter.count(state, 1, false);
    out = {std::max(out.states, one.states), std::max(out.bytes, one.bytes), std::max(out.depth, one.depth)};
  }
  return out;
}

}  // namespace race::rcm
