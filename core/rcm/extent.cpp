#include "core/rcm/extent.h"

#include <algorithm>
#include <unordered_map>

#include "core/rcm/after.h"
#include "core/rcm/constraints.h"

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

class Counter {
 public:
  explicit Counter(const Library& library) : library_(library) {}

  /// `level`: the depth of the recursion; beyond kMaxDepth the result only says that it is too deep.
  Extent count(const State& state, std::size_t level) {
    if (level > kMaxDepth) return {1, 0, kMaxDepth + 1};
    if (state.link) {
      const Extent linked = count_linked(*library_.find(*state.link), level + 1);
      return {linked.states, std::min(linked.bytes + bytes_of(state), kMaxBytes + 1), linked.depth + 1};
    }
    Extent out{1 + made_for_after(state), bytes_of(state), 0};
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      const Extent part = inner ? count(*inner, level + 1) : Extent{1, bytes_of(std::get<Barrier>(child)), 1};
      out.states = std::min(out.states + part.states, kMaxStates + 1);
      out.bytes = std::min(out.bytes + part.bytes, kMaxBytes + 1);
      out.depth = std::max(out.depth, part.depth);
    }
    return {out.states, out.bytes, out.depth + 1};
  }

 private:
  Extent count_linked(const State& state, std::size_t level) {
    if (const auto known = known_.find(&state); known != known_.end()) return known->second;
    const Extent out = count(state, level);
    return known_[&state] = out;
  }

  const Library& library_;
  std::unordered_map<const State*, Extent> known_;
};

}  // namespace

Extent extent_of(const Document& document, const Library& library) {
  Counter counter(library);
  Extent out = counter.count(document.root, 1);
  for (const State& state : document.library) {
    const Extent one = counter.count(state, 1);
    out = {std::max(out.states, one.states), std::max(out.bytes, one.bytes), std::max(out.depth, one.depth)};
  }
  return out;
}

}  // namespace race::rcm
