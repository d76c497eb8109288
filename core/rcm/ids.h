// Ids: who an element of a document is, whatever it is called and wherever it stands (`meta.id`, core/SEMANTICS.md,
// section 1). Elements are states, barriers, ports, parameters, results, variables and actions. Pure functions.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/rcm/model.h"

namespace race::rcm {

/// Whether `text` may be an id: 1 to 64 of A-Z a-z 0-9 _ -.
bool is_id(std::string_view text);

/// Gives an id to every element that has none. Of elements with the same id (a block that was copied as text) the first
/// keeps it, the root before the library; the others get new ones. With `previous`, the document before an edit that
/// lost ids or copied elements: an element that stands where an element of `previous` stands is the same one, unless
/// another element of `document` has its id; of elements with the same id, the one that stands where it stood keeps it,
/// else the one whose state (of a node: parent) stands where that stood. Where: kind and path; of an action the state,
/// its text and its number among equals.
///
/// A new id is a hash of where the element stands, so that the same document always gets the same ids and different
/// additions get different ones; it is none that `previous` has, and none that `layout` or the notes name. A `meta`
/// that is no object becomes the entry `value` of one. Keys of `layout` that are no ids but paths of nodes or ports
/// become their ids, unless there is an entry with this id; then they are left out. Others stay.
void give_ids(Document& document, const Document* previous = nullptr);

/// The id, of 13 characters, of what is made for the element `owner` from the element, or in the role, `part`: of what
/// a link takes over and of what an oracle is translated to. Empty if one of them is.
std::string derived_id(std::string_view owner, std::string_view part);

/// Beside an id, what `meta` is if it is no object becomes the entry `value`.
void wrap_rest(Meta& meta);

/// derived_id, or another id derived from that while an element of the document has it: so native ids are unique, even
/// if somebody pasted elements of the native model into the document.
class DerivedIds {
 public:
  /// Of no document: derived_id.
  DerivedIds() = default;
  explicit DerivedIds(const Document& document);

  std::string operator()(std::string_view owner, std::string_view part);

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::string> replacements_;  // of derived ids that are taken
};

}  // namespace race::rcm
