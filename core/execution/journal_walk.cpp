#include "core/execution/journal_walk.h"

#include <algorithm>
#include <string>

namespace race::execution {

Expected<JournalWalk> JournalWalk::create(const JournalHeader& header, std::shared_ptr<JournalSource> source,
                                          std::uint64_t last) {
  ASSIGN_OR_RETURN(Execution execution, Execution::create(header));
  return JournalWalk(std::move(execution), std::move(source), last);
}

Expected<const Progress*> JournalWalk::next(Recording recording) {
  const std::uint64_t position = execution_.run().position() + 1;
  if (position < first_ || position >= first_ + block_.size()) {
    ASSIGN_OR_RETURN(block_, source_->entries(position, std::min(last_, position + kEntriesAtOnce - 1)));
    first_ = position;
  }
  auto progress = execution_.replay(block_[position - first_], recording);
  if (!progress)
    return unexpected(progress.error().code, progress.error().message, "entries/" + std::to_string(position - 1));
  return progress;
}

}  // namespace race::execution
