// Library: what links mean (thesis 3.3.1). Finds the state that a linking state takes over, and what the link makes of
// its interface. Borrows the document.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/model.h"

namespace race::rcm {

class Library {
 public:
  explicit Library(const Document& document);

  /// The library's state `name` (the first of duplicates); nullptr if there is none.
  const State* find(std::string_view name) const;

  /// The state whose behaviour `state` has: itself, or the end of its chain of links. nullptr if a link leads to
  /// nothing or into a cycle.
  const State* behaviour(const State& state) const;

  /// What a link to the library's state `name` may override: the names of its behaviour. nullptr if it has none.
  struct Interface {
    std::set<std::string_view> parameters, ports;
  };
  const Interface* interface(std::string_view name) const;

  /// The parameters of `state`: its own, or those of the state it links with its expressions in place of theirs (where
  /// it has one), its type, texts and meta where it has them. Requires behaviour(state).
  std::vector<Parameter> parameters(const State& state) const;

  /// Cycles of links, each as its names, from the first in order of the library. Every cycle shares at least one state
  /// with one of these.
  std::vector<std::vector<std::string>> cycles() const;

 private:
  void resolve(std::size_t start, std::vector<bool>& known);

  const Document& document_;
  std::map<std::string_view, std::size_t> index_;
  std::vector<const State*> behaviours_;          // of each state of the library
  std::map<const State*, Interface> interfaces_;  // of those that are behaviours
};

/// The meta of a link: the id and the rest of `own`, each in place of that of `linked` if there is one; the rest entry
/// by entry if both are objects.
Meta merged_meta(const Meta& linked, const Meta& own);

/// The parameter `linked` as a link that names it overrides it.
void override_parameter(Parameter& linked, const Parameter& own);

}  // namespace race::rcm
