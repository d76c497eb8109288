// The file of a run (schemas/run_file.json): all of a run in one JSON text, which any server opens: its record, its
// journal, the document of which it was made, the RSMs of the moment, and samples of the cell. What the store has for
// it is read here, too.
//
// Threads: any.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/execution/journal.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "server/store/pictures.h"
#include "server/store/runs.h"
#include "server/store/samples.h"
#include "server/threads/work_progress.h"

namespace race::server {

inline constexpr int kRunFileVersion = 1;

/// What a run file may be: of one that is larger, nothing is written or read. A journal in it is as deep as one alone,
/// two levels further down.
inline constexpr JsonLimits kRunFileLimits{
    .depth = execution::kJournalLimits.depth + 2, .bytes = 16U << 20U, .keep_out_of_range = true};

/// That something is larger than the file of a run may be, and where to read the run instead.
tl::unexpected<Error> beyond_file_limits();

/// The text of a file of a run or a part of it, as kRunFileLimits allows. Error `too_large`, as beyond_file_limits().
Expected<std::string> bounded_text(const Value& json);
/// The whole journal of a stored run. No more is read than a file has room for. Errors: those of Runs; `too_large`, as
/// bounded_text.
Expected<execution::Journal> journal_of(const RunRecord& run, Runs& runs);
/// The same of the first `steps` entries of a run whose header is at hand.
Expected<execution::Journal> journal_of(RunId run, execution::JournalHeader header, std::uint64_t steps, Runs& runs);
/// The RSMs of a stored run. Errors: those of Runs; `corrupt`, at `services/KEY`: one of them is no RSM.
Expected<std::map<std::string, rsm::Service>> services_of(RunId run, Runs& runs);
/// All that is known of the times of a stored run; nothing if that is more than a file has room for. Errors: those of
/// Runs.
Expected<std::vector<TimingBlock>> timing_of(RunId run, Runs& runs);

struct RunFile {
  RunRecord record;
  execution::Journal journal;
  std::optional<Value> document;                 // schemas/document.json; none: that revision is not kept any more
  std::map<std::string, rsm::Service> services;  // the RSMs
  std::vector<Sample> samples;
  std::vector<TimingBlock> timing;  // none is written if there is no room
  std::vector<Picture> pictures;    // the same, before times
};

/// The text; without pictures, then without times if there is no room for them. Error `too_large`.
Expected<std::string> write_run_file(const RunFile& file);

/// Reads what write_run_file wrote, and holds it against itself: the journal against its chain, and the record against
/// what the journal comes to when it is done again. Errors, with paths: `json`, `too_large`, `too_deep`, `version`;
/// those of Fields, execution::read_journal (below `journal`), the document, the RSMs; `corrupt`: the chain or what
/// the run came to is another; `conflict`: an entry that the run does not take; `unavailable`: somebody has set `stop`
/// (which may be null) meanwhile. `checkpoints`: some on the way, as Runs::import takes them. `progress`, which may be
/// null, counts entries of the journal, each when it is done again and once more when it is stored.
Checked<RunFile> read_run_file_text(std::string_view text, std::map<std::uint64_t, std::string>* checkpoints = nullptr,
                                    const std::atomic<bool>* stop = nullptr, WorkProgress* progress = nullptr);
/// The part of that progress which is left for Runs::import.
inline WorkPart part_of_storing(WorkProgress* progress, const RunFile& file) {
  return {progress, file.record.steps, file.record.steps};
}

/// Whether a parsed text is the file of a run, not a journal alone.
bool is_run_file(const Value& json);
/// As read_run_file_text, of a text as parse_json gives it with kRunFileLimits.
Checked<RunFile> read_run_file(const Value& json, std::map<std::uint64_t, std::string>* checkpoints = nullptr,
                               const std::atomic<bool>* stop = nullptr, WorkProgress* progress = nullptr);

}  // namespace race::server
