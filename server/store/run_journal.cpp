#include "server/store/run_journal.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/value/json.h"

namespace race::server {
namespace {

void end_run(RunRecord& run, const RunEnd& end) {
  run.status = end.status;
  run.outcome = end.outcome;
  run.fault = end.fault;
  run.results = end.results;
  run.ended_ms = end.ended_ms;
}

}  // namespace

std::uint64_t RunJournal::interval_at(std::uint64_t position) {
  return kInterval * std::bit_ceil(std::max<std::uint64_t>(1, (position - 1) / (kInterval * kCheckpoints) + 1));
}

// A run that is written to is under way, unless this is its end.
PreparedRecord RunJournal::prepare(const JournalRecord& record, std::uint64_t most_bytes) {
  PreparedRecord prepared;
  prepared.ticket = record.ticket;
  prepared.is_full = record_.bytes >= most_bytes;
  prepared.failure = record.failure;
  if (record.failure) return prepared;
  RunRecord next = record_;
  next.status = "running";
  if (record.entry) prepared.entry = append_entry(next, *record.entry);
  if (record.checkpoint) {
    std::string text = to_json(*record.checkpoint);
    if (text.size() <= kCheckpointBytes) {
      next.bytes += text.size();
      prepared.checkpoint = checkpoint_row(next.id, next.steps, std::move(text));
    }
  }
  if (record.timing) prepared.timing = timing_row(*record.timing);
  if (record.end) end_run(next, *record.end);
  prepared.run = next;
  std::swap(record_, next);
  return prepared;
}

}  // namespace race::server
