#include "core/rcm/extent.h"

#include <algorithm>
#include <unordered_map>

#include "core/rcm/constraints.h"

namespace race::rcm {
namespace {

class Counter {
 public:
  explicit Counter(const Library& library) : library_(library) {}

  /// `level`: how deep the recursion is; beyond kMaxDepth it only says that this is too deep.
  Extent count(const State& state, std::size_t level) {
    if (level > kMaxDepth) return {1, kMaxDepth + 1};
    if (state.link) {
      const Extent linked = count_linked(*library_.find(*state.link), level + 1);
      return {linked.states, linked.depth + 1};
    }
    Extent out{1, 0};
    for (const Node& child : state.children) {
      const auto* inner = std::get_if<State>(&child);
      const Extent part = inner ? count(*inner, level + 1) : Extent{1, 1};
      out.states = std::min(out.states + part.states, kMaxStates + 1);
      out.depth = std::max(out.depth, part.depth);
    }
    return {out.states, out.depth + 1};
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
    out = {std::max(out.states, one.states), std::max(out.depth, one.depth)};
  }
  return out;
}

}  // namespace race::rcm
