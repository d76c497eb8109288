// Journals: any text is refused with a reason, or read as it stands; then the run is done again, until it does not take
// an entry, and its checkpoint is the same execution: one that goes on from the middle does the same steps.
#include "core/execution/journal.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/execution/checkpoint.h"
#include "core/execution/journal_walk.h"
#include "core/execution/step_json.h"
#include "core/value/json.h"
#include "tests/fuzz/support/bounded_header.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"
#include "tests/fuzz/support/json_mutator.h"

namespace race::execution {
namespace {

constexpr std::size_t kEntries = 50;

void hold_checkpoint(const JournalHeader& header, const Execution& execution) {
  const Value json = checkpoint_json(execution);
  const auto again = read_checkpoint(header, json);
  FUZZ_EXPECT(again);
  FUZZ_EXPECT(again->run().state_json() == execution.run().state_json());
  FUZZ_EXPECT(checkpoint_json(*again) == json);
}

void hold_step(Execution& restored, const JournalEntry& entry, Recording recording, const std::string& step) {
  const auto progress = restored.replay(entry, recording);
  FUZZ_EXPECT(progress);
  FUZZ_EXPECT(to_json(trace_step(restored.run().program(), **progress)) == step);
}

void replay(const Journal& journal) {
  const JournalHeader header = fuzz::bounded(journal.header);
  const std::size_t last = std::min(journal.entries.size(), kEntries);
  auto walk = JournalWalk::create(header, std::make_shared<MemoryJournal>(journal.entries), last);
  if (!walk) return;
  std::optional<Execution> restored;
  for (std::size_t done = 0; !walk->at_end(); ++done) {
    const Recording recording{.entry = true, .derivation = done % 2 == 0};
    const auto progress = walk->next(recording);
    if (!progress) return;
    const std::string step = to_json(trace_step(walk->execution().run().program(), **progress));
    FUZZ_EXPECT(parse_json(step, kJournalLimits).has_value());
    if (restored) hold_step(*restored, journal.entries[done], recording, step);
    if (done == last / 2 && !walk->execution().is_over())
      restored = read_checkpoint(header, checkpoint_json(walk->execution())).value();
  }
  if (!walk->execution().is_over()) hold_checkpoint(header, walk->execution());
}

void hold(std::string_view text) {
  const auto json = parse_json(text, kJournalLimits);
  if (!json) return;
  const auto journal = read_journal(*json);
  if (!journal) return FUZZ_EXPECT(!journal.error().empty());
  FUZZ_EXPECT(journal_json(*journal).find("entries")->as_list() == json->find("entries")->as_list());
  FUZZ_EXPECT(read_journal(journal_json(*journal)));
  (void)script_json(*journal);
  replay(*journal);
}

}  // namespace
}  // namespace race::execution

FUZZ_MUTATE_WITH(race::fuzz::mutate_json)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  race::execution::hold(race::fuzz::text_of(data, size));
  return 0;
}
