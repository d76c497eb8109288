// What the handlers of /api/v1/runs share: which run a request means, and its journal.
#include "server/handlers/runs.h"

#include <charconv>
#include <limits>

#include "server/runs/run_file.h"

namespace race::server {

Expected<std::uint64_t> query_number(const Request& request, std::string_view name, std::uint64_t least,
                                     std::uint64_t absent) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return absent;
  const std::string& text = found->second;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number >= least &&
      number <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    return number;
  return unexpected(ErrorCode::out_of_range, "must be a whole number from " + std::to_string(least), std::string(name));
}

RunId run_number(std::string_view text) {
  RunId id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  return error == std::errc() && end == text.data() + text.size() ? id : 0;
}

Expected<RunRecord> run_of(const Request& request, Runs& runs) {
  return runs.get(run_number(request.parameters.at("run")));
}

Expected<execution::Journal> journal_of(const RunRecord& run, Runs& runs) {
  if (run.steps > kRunFileEntries)
    return unexpected(ErrorCode::too_large, "the journal has " + std::to_string(run.steps) +
                                                " entries; `race replay` reads it where it is stored");
  ASSIGN_OR_RETURN(execution::JournalHeader header, runs.header(run.id));
  std::vector<execution::JournalEntry> entries;
  if (run.steps > 0) {
    ASSIGN_OR_RETURN(entries, runs.entries(run.id, *header.program, 1, run.steps));
  }
  return execution::Journal{std::move(header), std::move(entries)};
}

}  // namespace race::server
