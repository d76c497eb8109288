// What a core is made of, as requests name it: a document and arguments.
//
// Threads: any thread of the handlers' pool.
#pragma once

#include <optional>

#include "server/http/message.h"
#include "server/store/documents.h"

namespace race::server {

struct CoreModel {
  StoredDocument document;        // its last revision
  Dict arguments;                 // none: empty
  std::optional<bool> live = {};  // whether the core follows its document; nothing: not said
};

/// Reads a body as schemas/core_create.json or core_load.json and gets the document. Errors: every violation; those of
/// Documents::get.
Checked<CoreModel> read_core_model(const Request& request, Documents& documents);

}  // namespace race::server
