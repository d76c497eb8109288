// The fields of the elements of a tree, and of its document.
#include <utility>

#include "core/edit/extent.h"
#include "core/edit/tree.h"
#include "core/rcm/entries.h"

namespace race::edit {
namespace {

/// Gives the entry `key` of `entries` (an object or null) a value, or takes it away. Returns what it was.
std::optional<Value> exchange(Value& entries, std::string_view key, const std::optional<Value>& value) {
  std::optional<Value> old;
  if (const Value* found = entries.find(key)) old = *found;
  if (value) {
    if (!entries.is_dict()) entries = Dict();
    entries.mutable_dict().set(key, *value);
  } else if (old) {
    entries.mutable_dict().erase(key);
  }
  entries = rcm::ordered_entries(entries);
  return old;
}

tl::unexpected<Error> no_field(const Set& set, std::string_view of) {
  return unexpected(ErrorCode::unknown_field, std::string(of) + " has no field `" + set.field + "`", "field");
}

tl::unexpected<Error> wrong_value(std::string message) {
  return unexpected(ErrorCode::type, std::move(message), "value");
}

bool holds_entries(std::string_view field) {
  return field == "services" || field == "layout" || field == "notes" || field == "meta";
}

}  // namespace

Expected<Operation> Tree::set(const Set& set) {
  if (set.value) text_bound_ += edit::text_bound(set.key.value_or(""), *set.value);
  if (set.id.empty()) return set_document(set);
  Element* element = mutable_find(set.id);
  if (!element) return unexpected(ErrorCode::not_found, "there is no element `" + set.id + "`", "id");
  return set.field == "meta" ? set_meta(set, *element) : set_field(set, *element);
}

Expected<Operation> Tree::set_field(const Set& set, Element& element) {
  if (set.key) return unexpected(ErrorCode::unknown_field, "`" + set.field + "` has no entries", "key");
  if (list_of(set.field)) return no_field(set, "an element");
  if (set.value) {
    if (auto fits = check_level(*set.value, level(element.parent, element.list) + 1); !fits)
      return unexpected(fits.error().code, fits.error().message, "value");
  }
  const ListName list = element.list.value_or(ListName::children);
  Value json = write_content(element.content, list);
  std::optional<Value> old;
  if (const Value* found = json.find(set.field)) old = *found;
  if (set.value) {
    json.mutable_dict().set(set.field, *set.value);
  } else {
    json.mutable_dict().erase(set.field);
  }
  auto content = read_content(json, list);
  if (!content || content->index() != element.content.index()) {
    if (content) return no_field(set, "an element of this kind");
    const Error& error = content.error();
    return unexpected(error.code, error.message, error.code == ErrorCode::unknown_field ? "field" : "value");
  }
  element.content = std::move(*content);
  return Set{set.id, set.field, set.key, std::move(old)};
}

Expected<Operation> Tree::set_meta(const Set& set, Element& element) {
  if (!set.key) return unexpected(ErrorCode::missing, "the field `key` is missing: an entry of `meta`", "key");
  if (*set.key == "id") return unexpected(ErrorCode::not_accepted, "an element keeps its id", "key");
  if (set.value) {
    if (auto fits = check_level(*set.value, level(element.parent, element.list) + 2); !fits)
      return unexpected(fits.error().code, fits.error().message, "value");
  }
  Value& rest = meta_of(element.content).rest;
  if (!rest.is_null() && !rest.is_dict()) return wrong_value("the `meta` of this element is no object");
  return Set{set.id, set.field, set.key, exchange(rest, *set.key, set.value)};
}

Expected<Operation> Tree::set_document(const Set& set) {
  if (!holds_entries(set.field)) {
    if (set.field != "name") return no_field(set, "the document");
    if (set.key) return unexpected(ErrorCode::unknown_field, "`name` has no entries", "key");
    if (set.value && !set.value->is_string()) return wrong_value("`name` must be a string");
    std::string name = std::exchange(fields_.name, set.value ? set.value->as_string() : "");
    return Set{set.id, set.field, set.key, name.empty() ? std::nullopt : std::optional<Value>(std::move(name))};
  }
  if (!set.key) return unexpected(ErrorCode::missing, "the field `key` is missing: an entry of the field", "key");
  Set inverse = set;
  if (set.field == "services" || set.field == "notes") {
    if (set.value && !set.value->is_string()) return wrong_value("an entry of `" + set.field + "` must be a string");
  } else if (set.value) {
    if (auto fits = check_level(*set.value, 3); !fits)
      return unexpected(fits.error().code, fits.error().message, "value");
  }
  if (set.field == "services") {
    const auto found = fields_.services.find(*set.key);
    inverse.value.reset();
    if (found != fields_.services.end()) inverse.value = Value(found->second);
    if (set.value) {
      fields_.services[*set.key] = set.value->as_string();
    } else {
      fields_.services.erase(*set.key);
    }
    return inverse;
  }
  if (set.field == "layout") {
    inverse.value = exchange(fields_.layout, *set.key, set.value);
    return inverse;
  }
  Value& meta = fields_.meta;
  if (!meta.is_null() && !meta.is_dict()) return wrong_value("the `meta` of the document is no object");
  if (set.field == "meta") {
    if (*set.key == "notes") return unexpected(ErrorCode::not_accepted, "notes are the field `notes`", "key");
    inverse.value = exchange(meta, *set.key, set.value);
    return inverse;
  }
  const Value* found = meta.find("notes");
  Value notes = found ? *found : Value();
  inverse.value = exchange(notes, *set.key, set.value);
  exchange(meta, "notes", notes.is_null() ? std::nullopt : std::optional<Value>(std::move(notes)));
  return inverse;
}

}  // namespace race::edit
