#include "core/edit/operation.h"

#include <algorithm>
#include <array>

#include "core/rcm/ids.h"
#include "core/value/fields.h"

namespace race::edit {
namespace {

using Need = Fields::Need;

constexpr std::array<std::string_view, kListCount> kListNames = {"library", "parameters", "results", "variables",
                                                                 "actions", "children",   "ports"};

void write_place(Dict& out, const Place& place) {
  out.set("parent", place.parent);
  out.set("list", name(place.list));
  if (place.after) out.set("after", *place.after);
}

Value write(const Insert& insert) {
  Dict out{{"op", "insert"}};
  write_place(out, insert.place);
  out.set("node", insert.node);
  return out;
}

Value write(const Remove& remove) { return Dict{{"op", "remove"}, {"id", remove.id}}; }

Value write(const Move& move) {
  Dict out{{"op", "move"}, {"id", move.id}};
  write_place(out, move.place);
  return out;
}

Value write(const Set& set) {
  Dict out{{"op", "set"}, {"id", set.id}, {"field", set.field}};
  if (set.key) out.set("key", *set.key);
  if (set.value) out.set("value", *set.value);
  return out;
}

enum class Document { allowed, refused };

/// An id; the empty one, of the document, only where it is allowed.
std::string read_id(Fields& fields, std::string_view key, Need need, Document document) {
  auto id = fields.text(key, need);
  if (!id || rcm::is_id(*id) || (id->empty() && document == Document::allowed)) return std::move(id).value_or("");
  fields.violation(ErrorCode::name, "`" + std::string(key) + "` must be an id: 1 to 64 of A-Z a-z 0-9 _ -", key);
  return {};
}

Place read_place(Fields& fields) {
  Place out;
  out.parent = read_id(fields, "parent", Need::required, Document::allowed);
  if (const auto text = fields.text("list", Need::required)) {
    const auto list = list_of(*text);
    if (!list) fields.violation(ErrorCode::name, "there is no list `" + *text + "`", "list");
    out.list = list.value_or(ListName::children);
  }
  std::string after = read_id(fields, "after", Need::optional, Document::refused);
  if (!after.empty()) out.after = std::move(after);
  return out;
}

Operation read_insert(Fields& fields) {
  Insert out;
  out.place = read_place(fields);
  out.node = fields.constant("node", Need::required).value_or(Value());
  return out;
}

Operation read_move(Fields& fields) {
  std::string id = read_id(fields, "id", Need::required, Document::refused);
  return Move{std::move(id), read_place(fields)};
}

Operation read_set(Fields& fields) {
  Set out;
  out.id = read_id(fields, "id", Need::required, Document::allowed);
  out.field = fields.text("field", Need::required).value_or("");
  out.key = fields.text("key");
  out.value = fields.constant("value");
  return out;
}

Operation read_operation(Fields& fields) {
  const auto op = fields.text("op", Need::required);
  if (op == "insert") return read_insert(fields);
  if (op == "remove") return Remove{read_id(fields, "id", Need::required, Document::refused)};
  if (op == "move") return read_move(fields);
  if (op == "set") return read_set(fields);
  if (op) fields.violation(ErrorCode::name, "there is no operation `" + *op + "`", "op");
  return Set{};
}

}  // namespace

std::string_view name(ListName list) { return kListNames[static_cast<std::size_t>(list)]; }

std::optional<ListName> list_of(std::string_view name) {
  const auto found = std::ranges::find(kListNames, name);
  if (found == kListNames.end()) return std::nullopt;
  return static_cast<ListName>(found - kListNames.begin());
}

const Place* place_of(const Operation& operation) {
  if (const auto* insert = std::get_if<Insert>(&operation)) return &insert->place;
  if (const auto* move = std::get_if<Move>(&operation)) return &move->place;
  return nullptr;
}

Value write_edit(const Edit& edit) {
  List operations;
  for (const Operation& operation : edit.operations)
    operations.push_back(std::visit([](const auto& o) { return write(o); }, operation));
  return Dict{{"operations", std::move(operations)}};
}

Checked<Edit> read_edit(const Value& json) {
  std::vector<Error> errors;
  Fields fields(json, "", "edit", errors, Fields::Paths::field);
  const List& operations = fields.list("operations", Need::required);
  Edit out;
  if (operations.size() > kMaxOperations) {
    fields.violation(ErrorCode::too_large, "an edit has at most " + std::to_string(kMaxOperations) + " operations",
                     "operations");
    return tl::unexpected(std::move(errors));
  }
  for (std::size_t i = 0; i < operations.size(); ++i) {
    Fields one(operations[i], "operations/" + std::to_string(i), "operation", errors, Fields::Paths::field);
    out.operations.push_back(read_operation(one));
    if (one.find("op")) one.close();
  }
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  freeze(out);
  return out;
}

void freeze(Edit& edit) {
  for (Operation& operation : edit.operations) {
    if (auto* insert = std::get_if<Insert>(&operation)) insert->node.freeze();
    if (auto* set = std::get_if<Set>(&operation); set && set->value) set->value->freeze();
  }
}

}  // namespace race::edit
