#include "core/execution/checkpoint.h"

namespace race::execution {

Value checkpoint_json(const Execution&) { return Dict(); }

Expected<Execution> read_checkpoint(const JournalHeader& header, const Value&) {
  return Execution::create(header.program, header.arguments, header.budgets);
}

}  // namespace race::execution
