// Tree: a document as its edits see it, every element by its id. It is what a document is, in another shape: read() and
// document() lose nothing.
//
// A value, on one thread. Changing it costs what is changed; an operation that is refused changes nothing.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/edit/element.h"
#include "core/edit/operation.h"
#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "core/value/json.h"

namespace race::edit {

using Ids = std::vector<std::string>;

/// An element of a tree.
struct Element {
  std::string parent;                 // the id of the state that has it; empty: the document
  std::optional<ListName> list;       // of its parent; nothing: the root
  Content content;                    // without what is in the lists of a state
  std::array<Ids, kListCount> lists;  // by ListName
};

class Tree {
 public:
  /// Requires elements that all have ids, each another one (rcm::give_ids); else `missing` or `duplicate`.
  /// `one_line`: what the text may be of a document that is written on one line, such as a native model in a journal;
  /// of others, it is what rcm::write_document_text writes.
  static Expected<Tree> read(const rcm::Document& document, std::optional<JsonLimits> one_line = {});

  rcm::Document document() const;

  /// The element `id`; nullptr if there is none.
  const Element* find(std::string_view id) const;
  const std::string& root() const { return root_; }
  /// The elements of a list, in order; empty if there is no such state.
  const Ids& list(std::string_view parent, ListName list) const;
  /// The one before `id` in its list; nothing if it is the first. Requires an element that is not the root.
  std::optional<std::string> before(std::string_view id) const;
  /// Whether `id` is `ancestor` or below it.
  bool is_below(std::string_view ancestor, std::string_view id) const;
  /// `id` and all below it, in the order of the format. Requires an element.
  Ids subtree(std::string_view id) const;
  /// `id` with all below it, as the format has it. Requires an element.
  Value write(std::string_view id) const;
  /// The fields of the document: name, services, layout, meta. Without root and library.
  const rcm::Document& fields() const { return fields_; }
  std::size_t size() const { return elements_.size(); }
  /// Calls visit(element) for the root, the states of the library, and every element below them, parents first.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    visit_below({root_}, visit);
    visit_below(library_, visit);
  }

  /// The limits of read().
  const std::optional<JsonLimits>& one_line() const { return one_line_; }
  /// At least the size of the text of the document, in bytes: it grows with what is added and set.
  std::size_t text_bound() const { return text_bound_; }
  /// Once the size is known.
  void set_text_bound(std::size_t bytes) { text_bound_ = bytes; }

  // The operations of apply.h, one at a time. Each returns the operation that takes it back. Errors have the field of
  // the operation as path:
  //   not_found     there is no such element, or `after` is not in the list
  //   duplicate     the document has an element with this id
  //   missing       an element of a node has no id
  //   not_accepted  the root cannot be removed or moved, an element cannot move into itself
  //   type, ...     the element cannot be read with this field (rcm::read_draft), or the list is no place for it
  //   too_deep      the text of the document could not be read again
  Expected<Operation> insert(const Insert& insert);
  Expected<Operation> remove(const Remove& remove);
  Expected<Operation> move(const Move& move);
  Expected<Operation> set(const Set& set);

 private:
  static constexpr std::size_t kRootLevel = 2, kLibraryLevel = 3;
  using Elements = std::map<std::string, Element, std::less<>>;

  Expected<void> add(Content node, const std::string& parent, std::optional<ListName> list);
  Content compose(const Element& element) const;
  Element* mutable_find(std::string_view id);
  /// Where a list stands: an error if its parent does not have it, or `after` is not in it.
  Expected<std::size_t> position(const Place& place, std::string_view moved) const;
  Ids& ids(const std::string& parent, ListName list);
  void unlist(const Element& element, std::string_view id);
  template <typename Visit>
  void visit_below(const Ids& ids, const Visit& visit) const {
    for (const std::string& id : ids) {
      const Element& element = *find(id);
      visit(element);
      for (const Ids& list : element.lists) visit_below(list, visit);
    }
  }
  /// The level of JSON at which the object of an element of this list stands in the text of the document.
  std::size_t level(std::string_view parent, std::optional<ListName> list) const;
  Expected<Operation> set_document(const Set& set);
  Expected<Operation> set_meta(const Set& set, Element& element);
  Expected<Operation> set_field(const Set& set, Element& element);
  Expected<void> check_level(const Value& value, std::size_t level) const;

  std::optional<JsonLimits> one_line_;
  rcm::Document fields_;  // its library and root are empty
  Ids library_;
  std::string root_;
  Elements elements_;
  std::size_t text_bound_ = 0;
};

}  // namespace race::edit
