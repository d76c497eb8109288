#include "core/rcm/deep_history.h"

#include <algorithm>

namespace race::rcm {
namespace {

bool begins_with_state(const State& composite) {
  return composite.first && std::ranges::any_of(composite.children, [&](const Node& child) {
           return std::holds_alternative<State>(child) && name_of(child) == *composite.first;
         });
}

class Search {
 public:
  explicit Search(const Library& library) : library_(library) {}

  void visit(const State& state, bool inside) {
    if (state.link) return visit_linked(state, inside);
    const auto oracle = oracle_of(state, inside);
    if (oracle && !state.oracle) found_.insert(&state);
    for (const Node& child : state.children)
      if (const auto* inner = std::get_if<State>(&child)) visit(*inner, is_deep(oracle));
  }
  std::set<const State*> take() { return std::move(found_); }

 private:
  // What a library state contains is the same for all links, once it is known to be inside.
  void visit_linked(const State& link, bool inside) {
    const State* linked = library_.find(*link.link);
    if (linked && inside && inside_.insert(linked).second) visit(*linked, true);
  }

  const Library& library_;
  std::set<const State*> inside_, found_;
};

}  // namespace

std::optional<Oracle> oracle_of(const State& state, bool inside) {
  std::optional<Oracle> out = state.oracle;
  if (!inside) return out;
  if (out && out->kind == Oracle::Kind::history) out->deep = true;
  if (!out && !state.keep && begins_with_state(state))
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
