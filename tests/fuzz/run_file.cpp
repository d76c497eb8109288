// The files of runs: any text is refused with a reason, or read; what is read is written and read again. As the journal
// of a changed file no longer has its chain, its chain is made anew before it is read.
#include "server/runs/run_file.h"

#include "core/value/json.h"
#include "server/store/journal_chain.h"
#include "tests/fuzz/support/bounded_header.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"
#include "tests/fuzz/support/json_mutator.h"

namespace race::server {
namespace {

// Also the budgets of its journal are small ones.
Value with_chain(Value file) {
  const Value *run = file.find("run"), *json = file.find("journal");
  if (!run || !run->is_dict() || !json) return file;
  auto journal = execution::read_journal(*json);
  if (!journal) return file;
  journal->header = fuzz::bounded(std::move(journal->header));
  sqlite::Digest chain = header_chain(journal->header);
  for (const execution::JournalEntry& entry : journal->entries) chain = chain_after(chain, input_text(entry));
  Value record = *run;
  record.mutable_dict().set("chain", sqlite::hex(chain));
  record.mutable_dict().set("steps", static_cast<std::int64_t>(journal->entries.size()));
  record.mutable_dict().set("arguments", journal->header.arguments);
  file.mutable_dict().set("run", std::move(record));
  file.mutable_dict().set("journal", execution::journal_json(*journal));
  return file;
}

void hold(std::string_view text) {
  const auto json = parse_json(text, kRunFileLimits);
  if (!json || !is_run_file(*json)) return;
  const auto file = read_run_file(with_chain(*json));
  if (!file) return FUZZ_EXPECT(!file.error().empty());
  const auto written = write_run_file(*file);
  FUZZ_EXPECT(written);
  std::map<std::uint64_t, std::string> checkpoints;
  const auto again = read_run_file(with_chain(parse_json(*written, kRunFileLimits).value()), &checkpoints);
  FUZZ_EXPECT(again);
  FUZZ_EXPECT(write_run_file(*again) == written);
}

}  // namespace
}  // namespace race::server

FUZZ_MUTATE_WITH(race::fuzz::mutate_json)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  race::server::hold(race::fuzz::text_of(data, size));
  return 0;
}
