// Edits: what changes a document (core/SEMANTICS.md, section 1), as values. Four operations on the tree of elements,
// which are named by their ids; the empty id is the document itself. An edit is a list of operations, applied in order,
// as a whole or not at all (apply.h).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::edit {

/// The lists of elements, under their names in the format: `library` of the document, the others of a state.
enum class ListName { library, parameters, results, variables, actions, children, ports };
inline constexpr std::size_t kListCount = 7;
std::string_view name(ListName list);
std::optional<ListName> list_of(std::string_view name);

/// Where an element stands: in a list of the state `parent` (empty: the document), behind the element `after` of this
/// list, at its front if there is none.
struct Place {
  std::string parent;
  ListName list = ListName::children;
  std::optional<std::string> after;
  bool operator==(const Place&) const = default;
};

/// Adds an element with all below it. Each of them has an id that the document does not have.
struct Insert {
  Place place;
  Value node;  // as the format has it
  bool operator==(const Insert&) const = default;
};
/// Takes an element away, with all below it. The root stays.
struct Remove {
  std::string id;
  bool operator==(const Remove&) const = default;
};
/// Moves an element, with all below it. The root stays.
struct Move {
  std::string id;
  Place place;
  bool operator==(const Move&) const = default;
};
/// Gives a field a value, or takes it away (no value). With `key`, an entry of the field: of an element's `meta`; of
/// the document's `services`, `layout`, `notes` (of its meta) and `meta` (the rest of it).
struct Set {
  std::string id;
  std::string field;
  std::optional<std::string> key;
  std::optional<Value> value;
  bool operator==(const Set&) const = default;
};
using Operation = std::variant<Insert, Remove, Move, Set>;

/// Where an operation puts its element; nullptr if nowhere.
const Place* place_of(const Operation& operation);

struct Edit {
  std::vector<Operation> operations;
  bool operator==(const Edit&) const = default;
};

/// How many operations one edit may have.
inline constexpr std::size_t kMaxOperations = 10'000;

/// schemas/edit.json
Value write_edit(const Edit& edit);

/// Reads what write_edit wrote. Its values are frozen. Violations name the field (`operations/0/list`): `missing`,
/// `type`, `unknown_field`, `constant`, `name` (no id, or there is no such list or operation); `too_large` (more than
/// kMaxOperations).
Checked<Edit> read_edit(const Value& json);

/// Makes the values of an edit safe to share between threads.
void freeze(Edit& edit);

}  // namespace race::edit
