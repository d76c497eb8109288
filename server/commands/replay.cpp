// race replay [--text] JOURNAL: does a run again from its journal (GET /api/v1/cores/ID/journal) and prints its
// derivations as race derive does. Exit 1 if the run faulted.
#include "core/execution/replay.h"

#include <memory>

#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/commands/print_derivations.h"

namespace race::server {
namespace {

int replay(const std::string& path, bool as_text) {
  const auto text = read_file(path);
  if (!text) return refuse(text.error(), !as_text);
  const auto json = parse_json(*text, execution::kJournalLimits);
  if (!json) return refuse(json.error(), !as_text);
  const auto journal = execution::read_journal(*json);
  if (!journal) return refuse(journal.error(), !as_text);
  const auto document = execution::derive_journal(*journal);
  if (!document) return refuse(document.error(), !as_text);
  return print_derivations(*document, as_text);
}

std::function<int()> declare(Arguments& arguments) {
  struct Options {
    std::string journal;
    bool as_text = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.positional("JOURNAL", options->journal);
  arguments.flag("--text", options->as_text, "as a transcript: one node a line");
  return [options] { return replay(options->journal, options->as_text); };
}

}  // namespace

const Command kReplay = {"replay", "does a run again from its journal and prints its derivations", declare};

}  // namespace race::server
