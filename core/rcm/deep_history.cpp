#include "core/rcm/deep_history.h"

#include <algorithm>

namespace race::rcm {
namespace {

bool is_state(const Node& node) { return std::holds_alternative<State>(node); }

/// Whether one child at a time is active: the first is a state, and no barrier leads to several.
bool has_one_active_child(const State& composite) {
  const auto is_first = [&](const Node& child) { return is_state(child) && name_of(child) == *composite.first; };
  const auto is_fork = [](const Node& child) { return !is_state(child) && std::get<Barrier>(child).to.size() > 1; };
  return composite.first && std::ranges::any_of(composite.children, is_first) &&
         std::ranges::none_of(composite.children, is_fork);
}

/// Goes through the document, along its links without recursion: they can form long chains.
class Search {
 public:
  explicit Search(const Library& library) : library_(library) {}

  void visit(const State& state, bool inside) {
    if (state.link) return visit_linked(state, inside);
    const auto oracle = oracle_of(state, inside);
    if (oracle && !state.oracle) found_.insert(&state);
    for (const Node& child : state.children)
      if (is_state(child)) visit(std::get<State>(child), is_deep(oracle));
  }
  std::set<const State*> take() {
    while (!waiting_.empty()) {
      const State& linked = *waiting_.back();
      waiting_.pop_back();
      visit(linked, true);
    }
    return std::move(found_);
  }

 private:
  // What a library state contains is the same for all links, once it is known to be inside.
  void visit_linked(const State& link, bool inside) {
    const State* linked = library_.find(*link.link);
    if (linked && inside && inside_.insert(linked).second) waiting_.push_back(linked);
  }

  const Library& library_;
  std::set<const State*> inside_, found_;
  std::vector<const State*> waiting_;
};

}  // namespace

std::optional<Oracle> oracle_of(const State& state, bool inside) {
  std::optional<Oracle> out = state.oracle;
  if (!inside) return out;
  if (out && out->kind == Oracle::Kind::history) out->deep = true;
  if (!out && !state.keep && has_one_active_child(state))
    out = Oracle{.kind = Oracle::Kind::history, .text = "", .resume = {{}}, .deep = true};
  return out;
}

std::set<const State*> resumed_states(const Document& document, const Library& library) {
  Search search(library);
  for (const State& state : document.library) search.visit(state, false);
  search.visit(document.root, false);
  return search.take();
}

bool is_resumed(const Document& document, std::string_view id) {
  return std::ranges::any_of(resumed_states(document, Library(document)),
                             [&](const State* state) { return state->meta.id == id; });
}

}  // namespace race::rcm
