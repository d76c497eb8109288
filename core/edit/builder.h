// Builder: makes a compound edit, one operation after the other, on a copy of the document.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

class Builder {
 public:
  explicit Builder(const Tree& tree) : tree_(tree) {}

  /// The document after the operations so far.
  const Tree& tree() const { return tree_; }

  /// Adds an operation. The first that cannot be applied is the error of the edit; those after it are left out.
  void add(Operation operation);
  /// The same for a field of an element, if its value is another one.
  void set(std::string_view id, std::string_view field, std::optional<Value> value);
  void fail(Error error);
  bool failed() const { return error_.has_value(); }

  Expected<Edit> take();

 private:
  Tree tree_;
  Edit edit_;
  std::optional<Error> error_;
};

/// Ids for new elements: made of a seed, each another one, none that the document has or that its layout or notes name.
class NewIds {
 public:
  NewIds(const Tree& tree, std::string_view seed);
  /// For what is made for `role`, such as a copy of the element of this id.
  std::string operator()(std::string_view role);

 private:
  const Tree& tree_;
  std::string seed_;
  std::set<std::string, std::less<>> taken_;
};

/// The state, or nullptr if `id` is none.
const rcm::State* state_of(const Tree& tree, std::string_view id);
/// The state whose behaviour a state has: itself, or where its links lead; empty if they lead nowhere.
std::string behaviour_of(const Tree& tree, std::string_view id);
const std::string& name_of(const Tree& tree, std::string_view id);
/// The element of a list with this name; empty if there is none.
std::string find_by_name(const Tree& tree, std::string_view parent, ListName list, std::string_view name);
/// `wanted`, or with the first number from 2 that makes it a name which nothing in the list has.
std::string free_name(const Tree& tree, std::string_view parent, ListName list, const std::string& wanted);

tl::unexpected<Error> no_element(std::string_view id, std::string_view argument);
/// Errors `name` and `duplicate` if `name` cannot be the name of an element in this list.
Expected<void> check_new_name(const Tree& tree, std::string_view parent, ListName list, std::string_view name);

}  // namespace race::edit
