// What comes of an edit, as clients see it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/store/documents.h"

namespace race::server {

/// How many edits an author can take back, and how many undos.
struct EditDepths {
  std::size_t undo = 0, redo = 0;
};

/// schemas/accepted_edit.json, frozen. `errors`: of the document after it.
Value accepted_edit_json(const DocumentPast::Edit& accepted, const std::vector<Error>& errors, EditDepths depths);

/// What the channel of a document begins with (schemas/stream_message.json, `document_snapshot`), frozen.
Value document_snapshot_json(const DocumentEntry& entry);

/// Why an edit was not accepted. Nothing is changed.
struct EditRefusal {
  enum class Of {
    document,      // there is none that can be edited now
    precondition,  // EditRequest::if_match
    edit,          // the edit itself
  };
  Of of = Of::edit;
  std::vector<Error> errors;  // at least one
  std::int64_t revision = 0;  // the edit that is the reason; 0: none is
  std::string author = {};    // of that edit
};

/// schemas/stream_message.json, `edit_refusal`, frozen.
Value edit_refusal_json(const std::string& document, const std::string& token, const EditRefusal& refusal);

}  // namespace race::server
