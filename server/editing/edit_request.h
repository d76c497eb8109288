// EditRequest: what a client asks for (schemas/edit_request.json, and the message `edit` of stream_request.json). Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/edit/log.h"
#include "core/edit/operation.h"
#include "core/value/fields.h"
#include "server/editing/compound_request.h"

namespace race::server {

struct EditRequest {
  enum class TakeBack { undo, redo };

  std::optional<edit::Revision> revision;  // that its author has seen
  std::optional<edit::Revision> if_match;  // that must be the last one
  std::string author, message;
  std::string token;  // `request`; may be empty
  std::variant<edit::Edit, CompoundRequest, TakeBack> what;
};

/// Reads the fields of a request but those of its transport; the caller closes `fields`. Adds violations to `errors`,
/// which is that of `fields`: those of edit::read_edit; `missing`: not exactly one of operations, compound, undo and
/// redo
/// (`conflict` would say that others have changed the document); `name`: a token that is none; `too_large`: author or
/// message.
EditRequest read_edit_request(Fields& fields, std::vector<Error>& errors);

}  // namespace race::server
