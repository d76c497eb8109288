#include "server/store/journal_chain.h"

#include "core/value/json.h"

namespace race::server {

sqlite::Digest header_chain(const execution::JournalHeader& header) {
  return sqlite::sha256_of({to_json(execution::header_json(header))});
}

sqlite::Digest chain_after(const sqlite::Digest& before, std::string_view input) {
  return sqlite::sha256_of({sqlite::bytes(before), input});
}

std::string input_text(const execution::JournalEntry& entry) { return to_json(execution::input_json(entry)); }

}  // namespace race::server
