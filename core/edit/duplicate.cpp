// Copies of elements.
#include "core/edit/builder.h"
#include "core/edit/compound.h"

namespace race::edit {
namespace {

/// Gives every element of a node a new id; `copies`: the old id and the new one of each.
void renew_ids(Value& node, NewIds& ids, std::vector<std::pair<std::string, std::string>>& copies) {
  Dict& fields = node.mutable_dict();
  Value meta = *node.find("meta");
  const std::string old = meta.find("id")->as_string();
  copies.emplace_back(old, ids(old));
  meta.mutable_dict().set("id", copies.back().second);
  fields.set("meta", std::move(meta));
  for (std::size_t i = 0; i < kListCount; ++i) {
    const std::string_view list = name(static_cast<ListName>(i));
    const Value* found = node.find(list);
    if (!found) continue;
    List elements = found->as_list();
    for (Value& element : elements) renew_ids(element, ids, copies);
    fields.set(list, std::move(elements));
  }
}

}  // namespace

Expected<Edit> duplicate(const Tree& tree, std::string_view id, std::string_view seed) {
  const Element* element = tree.find(id);
  if (!element) return no_element(id, "id");
  if (!element->list) return unexpected(ErrorCode::not_accepted, "a document has one root", "id");
  Value node = tree.write(id);
  NewIds ids(tree, seed);
  std::vector<std::pair<std::string, std::string>> copies;
  renew_ids(node, ids, copies);
  if (const std::string_view field = name_field(element->content); !field.empty())
    node.mutable_dict().set(field, free_name(tree, element->parent, *element->list, name_of(element->content)));
  Builder builder(tree);
  builder.add(Insert{{element->parent, *element->list, std::string(id)}, std::move(node)});
  for (std::size_t i = 1; i < copies.size(); ++i) {  // the copy itself cannot be where the element is
    if (const Value* drawn = tree.fields().layout.find(copies[i].first))
      builder.add(Set{"", "layout", copies[i].second, *drawn});
  }
  return builder.take();
}

}  // namespace race::edit
