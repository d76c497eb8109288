// The chain of hashes over a journal: each entry's covers the header and every entry up to it, so that two journals are
// the same when their last ones are.
//
// Threads: any.
#pragma once

#include <string>
#include <string_view>

#include "core/execution/journal.h"
#include "services/sqlite/digest.h"

namespace race::server {

/// The chain before the first entry: of the header's text, arguments included.
sqlite::Digest header_chain(const execution::JournalHeader& header);

/// The chain after the entry of this text, of the one before it.
sqlite::Digest chain_after(const sqlite::Digest& before, std::string_view input);

/// The text of an entry as it is stored and hashed: schemas/input.json.
std::string input_text(const execution::JournalEntry& entry);

}  // namespace race::server
