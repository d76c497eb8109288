// What the file of a stored run is made of (run_file.h), from the store.
#include <algorithm>
#include <utility>

#include "core/rsm/document.h"
#include "server/runs/run_file.h"
#include "server/store/journal_chain.h"

namespace race::server {
namespace {

constexpr std::uint64_t kBlock = 64;  // entries read at once

}  // namespace

Expected<execution::Journal> journal_of(const RunRecord& run, Runs& runs) {
  ASSIGN_OR_RETURN(execution::JournalHeader header, runs.header(run.id));
  return journal_of(run.id, std::move(header), run.steps, runs);
}

Expected<execution::Journal> journal_of(RunId run, execution::JournalHeader header, std::uint64_t steps, Runs& runs) {
  execution::Journal journal{std::move(header), {}};
  for (std::uint64_t from = 1, bytes = 0; from <= steps; from += kBlock) {
    ASSIGN_OR_RETURN(const auto block, runs.entries(run, from, std::min(steps, from + kBlock - 1)));
    for (const execution::JournalEntry& entry : block) bytes += input_text(entry).size();
    if (bytes > kRunFileLimits.bytes) return beyond_file_limits();
    journal.entries.insert(journal.entries.end(), block.begin(), block.end());
  }
  return journal;
}

Expected<std::map<std::string, rsm::Service>> services_of(RunId run, Runs& runs) {
  std::map<std::string, rsm::Service> services;
  ASSIGN_OR_RETURN(const Value stored, runs.services(run));
  if (!stored.is_dict()) return unexpected(ErrorCode::corrupt, "what is stored are no RSMs", "services");
  for (const auto& [key, json] : stored.as_dict()) {
    const std::string path = "services/" + key.as_string();
    auto service = rsm::read_service(json, path);
    if (!service)
      return unexpected(ErrorCode::corrupt, "what is stored is no RSM: " + service.error().front().message, path);
    services.emplace(key.as_string(), std::move(*service));
  }
  return services;
}

Expected<std::vector<TimingBlock>> timing_of(RunId run, Runs& runs) {
  constexpr std::size_t kStep = 8, kChange = 30;  // bytes of text, at least
  std::vector<TimingBlock> blocks;
  std::size_t bytes = 0;
  const auto read = runs.timing(run, 0, {}, [&](const TimingBlock& block) {
    bytes += kStep * block.steps.size() + kChange * block.services.size();
    blocks.push_back(block);
    return bytes <= kRunFileLimits.bytes;
  });
  if (!read) return tl::unexpected(read.error());
  if (bytes > kRunFileLimits.bytes) blocks.clear();
  return blocks;
}

}  // namespace race::server
