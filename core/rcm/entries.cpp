#include "core/rcm/entries.h"

#include <utility>

namespace race::rcm {

Value ordered_entries(const Value& entries) {
  if (!entries.is_dict()) return entries;
  const Dict& dict = entries.as_dict();
  if (dict.empty()) return Value();
  return dict.is_sorted() ? entries : Value(dict.sorted());
}

Value ordered_document_meta(const Value& meta) {
  const Value* notes = meta.find("notes");
  if (!notes) return ordered_entries(meta);
  Value ordered = ordered_entries(*notes);
  if (ordered.identical(*notes)) return ordered_entries(meta);
  Dict out = meta.as_dict();
  if (ordered.is_null()) {
    out.erase("notes");
  } else {
    out.set("notes", std::move(ordered));
  }
  return ordered_entries(out);
}

Value meta_json(const Meta& meta) {
  Value rest = ordered_entries(meta.rest);
  if (meta.id.empty()) return rest;
  Dict entries{{"id", meta.id}};
  if (rest.is_dict()) {
    for (const auto& [key, value] : rest.as_dict()) entries.set(key, value);
  }
  return entries;
}

}  // namespace race::rcm
