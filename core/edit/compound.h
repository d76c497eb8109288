// Compound edits: what one wants to do with a document, made of the operations of operation.h. Each is a function of
// the document; who applies it to another document than the one it was made for makes it again, rather than apply the
// old operations: names and positions are those of the document. Pure functions.
//
// Errors: `not_found`, there is no such element (path: the argument); `not_accepted`, it is no element to do this with;
// `name`, a new name is none; `duplicate`, it is taken; `syntax`, a text that cannot be parsed may name what changes;
// `scope`, a link takes over the `from` of a parameter from the library, which would have to be another one for this
// link alone (path: the link).
// Others are said below. In an error about a text or an element, the path is the id of the element.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

/// Gives an element another name, everywhere: in ports, barriers, `first`, `keep`, oracles and links, and in code
/// (`chi.A`, `par.x`, `par["x"]`), also through links to a state of the library. An oracle `expr` names a child by a
/// text that is its value: 'A', and in both branches of a condition. Names that code computes stay as they are.
/// `link_port`, `link_parameter`: what a link overrides is renamed in the library.
Expected<Edit> rename(const Tree& tree, std::string_view id, std::string_view name);

/// Gives a service another key: in `services` and in code (`svc.KEY`, `svc["KEY"]`). `not_found` if nothing names it;
/// `duplicate` also if code uses a service `name` that is not in `services`.
Expected<Edit> rename_service(const Tree& tree, std::string_view key, std::string_view name);

/// Lets a port lead to a sibling of its state (`to`), or nowhere (no `to`); lets a barrier lead to one more sibling
/// state.
Expected<Edit> connect(const Tree& tree, std::string_view from, std::optional<std::string_view> to);

/// Lets a barrier no longer lead to a state.
Expected<Edit> disconnect(const Tree& tree, std::string_view barrier, std::string_view state);

/// Puts siblings into a new state `name`, which stands where the first of them stood. It has
/// - `first`: the one to which ports, barriers and `first` from outside lead; `first` (error) if there are several, or
///   if it is a barrier
/// - ports: `A_done` for each port `done` of a state A that leads outside or is read by the parent; fires when that is
///   active
/// - parameters: one for each parameter of the parent, and for each result or parameter of a sibling outside, that the
///   parameters of the states read; taken when the group is entered
/// - results: one for each result that code of the parent reads, with an action that takes it over, once in a macro
///   step, so the parent may see a change one macro step later
///
/// It keeps its values (`keep`). `keep`: a state that does so itself would not when the group is entered again.
/// `scope`: the parameters of a state read something else of the parent (its results, variables, or `par` as a whole),
/// or the parent reads something else of a state (whether it is active, its parameters, a port that leads to another
/// state of the group). `oracle`: the parent chooses among its children. `barrier_target`: a barrier inside leads
/// outside, or has sources outside. New elements get ids made of `seed`, which differs from one edit to the next.
Expected<Edit> group(const Tree& tree, const Ids& ids, std::string_view name, std::string_view seed);

/// Takes the children of a state out of it, to where it stands: what group() makes, and what is alike. `not_accepted`,
/// with the reason, for a state that does something itself.
Expected<Edit> ungroup(const Tree& tree, std::string_view id);

/// A copy of an element with all below it, behind it, under a free name (`A2`) and with new ids made of `seed`.
Expected<Edit> duplicate(const Tree& tree, std::string_view id, std::string_view seed);

/// Moves a state to the library, under `name`, and puts a link in its place, with its parameters' expressions, and its
/// ports' targets. All that is in the state keeps its ids; the link and what it overrides get new ones made of `seed`.
Expected<Edit> extract(const Tree& tree, std::string_view id, std::string_view name, std::string_view seed);

}  // namespace race::edit
