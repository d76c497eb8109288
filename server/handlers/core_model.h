// What a core is made of, as requests name it: a document and arguments.
//
// Threads: any thread of the handlers' pool.
#pragma once

#include "server/execution/live_edits.h"
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

/// Lets a core of this model follow its document, or not, as the request says. Gives the core. Errors: as
/// Core::set_live.
Expected<Value> follow_document(Core& core, const CoreModel& model, LiveEdits& edits);

}  // namespace race::server
