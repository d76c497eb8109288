#include "server/editing/presence_request.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/language/primitives/utf8.h"
#include "core/rcm/ids.h"
#include "core/value/fields.h"

namespace race::server {
namespace {

bool is_space(char c) { return c == ' '; }

// Control characters of ASCII; what else a text may look like is its reader's concern.
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

void read_name(Fields& fields, Dict& out) {
  const auto name = fields.text("name", kRequired);
  if (!name) return;
  if (language::utf8::length(*name) > PresenceRequest::kMaxName)
    fields.violation(ErrorCode::too_large, "has more than " + std::to_string(PresenceRequest::kMaxName) + " characters",
                     "name");
  else if (std::ranges::all_of(*name, is_space) || std::ranges::any_of(*name, is_control))
    fields.violation(ErrorCode::name, "a name has a character that is no space, and no control characters", "name");
  else
    out.set("name", *name);
}

constexpr const char* kIdRule = "an id is 1 to 64 of A-Z a-z 0-9 _ -";

std::string read_id(Fields& fields, const char* key, Fields::Need need) {
  auto id = fields.text(key, need);
  if (id && !rcm::is_id(*id)) fields.violation(ErrorCode::name, kIdRule, key);
  return std::move(id).value_or("");
}

// One that is absent or wrong is left out.
void copy_id(Fields& fields, const char* key, Fields::Need need, Dict& out) {
  if (std::string id = read_id(fields, key, need); !id.empty()) out.set(key, std::move(id));
}

void read_selection(Fields& fields, Dict& out) {
  const std::vector<std::string> ids = fields.texts("selection");
  if (ids.size() > PresenceRequest::kMaxSelection)
    return fields.violation(ErrorCode::too_large,
                            "has more than " + std::to_string(PresenceRequest::kMaxSelection) + " elements",
                            "selection");
  if (!std::ranges::all_of(ids, rcm::is_id)) return fields.violation(ErrorCode::name, kIdRule, "selection");
  if (!ids.empty()) out.set("selection", List(ids.begin(), ids.end()));
}

void read_text(const Value& json, std::vector<Error>& errors, Dict& out) {
  Fields fields(json, "text", "the text", errors, kByField);
  Dict text;
  copy_id(fields, "element", Fields::Need::optional, text);
  if (const auto field = fields.text("field", kRequired)) {
    if (field->empty() || language::utf8::length(*field) > PresenceRequest::kMaxField)
      fields.violation(ErrorCode::too_large, "a field has a name of 1 to 128 characters", "field");
    text.set("field", *field);
  }
  if (const auto offset = fields.integer("offset", 0, PresenceRequest::kMaxOffset, kRequired))
    text.set("offset", *offset);
  fields.close();
  out.set("text", std::move(text));
}

void read_coordinate(Fields& fields, const char* key, Dict& out) {
  fields.find(key, kRequired);
  const auto number = fields.number(key);
  if (!number) return;
  if (std::abs(*number) <= PresenceRequest::kMaxCoordinate)
    out.set(key, *number);
  else
    fields.violation(ErrorCode::out_of_range, "a coordinate is at most 1e6 from 0", key);
}

void read_pointer(const Value& json, std::vector<Error>& errors, Dict& out) {
  Fields fields(json, "pointer", "the pointer", errors, kByField);
  Dict pointer;
  copy_id(fields, "element", kRequired, pointer);
  read_coordinate(fields, "x", pointer);
  read_coordinate(fields, "y", pointer);
  fields.close();
  out.set("pointer", std::move(pointer));
}

}  // namespace

PresenceRequest read_presence_request(const Value& message, std::vector<Error>& errors) {
  Fields fields(message, "", "the message", errors, kByField);
  fields.find("type");
  PresenceRequest out;
  out.document = read_id(fields, "document", kRequired);
  Dict person;
  read_name(fields, person);
  copy_id(fields, "level", Fields::Need::optional, person);
  read_selection(fields, person);
  if (const Value* text = fields.find("text")) read_text(*text, errors, person);
  if (const Value* pointer = fields.find("pointer")) read_pointer(*pointer, errors, person);
  fields.close();
  out.person = Value(std::move(person));
  return out;
}

}  // namespace race::server
