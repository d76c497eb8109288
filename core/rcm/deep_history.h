// Deep histories (core/SEMANTICS.md, section 6): which states inside a history that is `deep` resume, too. Pure
// functions.
#pragma once

#include <optional>
#include <set>
#include <string_view>

#include "core/rcm/library.h"
#include "core/rcm/model.h"

namespace race::rcm {

/// Whether the states inside resume, too.
inline bool is_deep(const std::optional<Oracle>& oracle) { return oracle && oracle->deep; }

/// The oracle by which `state`, which links no other, is translated. `inside`: its parent resumes by a deep history.
/// Then a history is deep, too; and a composite without oracle and `keep`, of whose children one at a time is active
/// (its `first` is a state, and no barrier leads to several), has a deep history that resumes it through no port of its
/// own, but when it was left with its parent. All others begin anew.
std::optional<Oracle> oracle_of(const State& state, bool inside);

/// The states of the document that a deep history contains, directly or by links, and that it resumes: those to which
/// oracle_of() gives an oracle that they do not have themselves.
std::set<const State*> resumed_states(const Document& document, const Library& library);

/// Whether the state with this id is one of them.
bool is_resumed(const Document& document, std::string_view id);

}  // namespace race::rcm
