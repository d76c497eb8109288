// race replay RUN [--data DIR] [--text] [--hash]: does a run again from its journal and prints its derivations as race
// derive does, or their hash. RUN is a file (GET /api/v1/runs/ID/export, or .../journal) or, with --data, the number of
// a stored run, whose checkpoints are held against what is recomputed. Exit 1 if the run faulted.
#include "core/execution/replay.h"

#include <cstdio>
#include <memory>

#include "core/execution/checkpoint.h"
#include "core/execution/journal_walk.h"
#include "core/execution/step_json.h"
#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/commands/input.h"
#include "server/commands/print_derivations.h"
#include "server/commands/run_number.h"
#include "server/runs/run_file.h"
#include "server/store/journal_chain.h"
#include "server/store/runs.h"

namespace race::server {
namespace {

struct Options {
  std::string run;
  std::optional<std::string> data;
  bool as_text = false, hash = false;
};

/// A run that is to be done again.
struct Replayed {
  execution::JournalHeader header;
  std::shared_ptr<execution::JournalSource> source;
  std::uint64_t steps = 0;
  std::vector<std::uint64_t> checkpoints = {};  // positions of those that are stored
  std::unique_ptr<Runs> store = {};             // that the source reads
};

Checked<Replayed> of_journal(execution::Journal journal) {
  const std::size_t steps = journal.entries.size();
  return Replayed{std::move(journal.header), std::make_shared<execution::MemoryJournal>(std::move(journal.entries)),
                  steps};
}

Checked<Replayed> of_file(const std::string& path) {
  const auto text = read_input(path);
  if (!text) return tl::unexpected(std::vector<Error>{text.error()});
  const auto json = parse_json(*text, execution::kJournalLimits);
  if (!json) return tl::unexpected(std::vector<Error>{json.error()});
  if (is_run_file(*json)) {
    auto file = read_run_file(*json);
    if (!file) return tl::unexpected(std::move(file).error());
    return of_journal(std::move(file->journal));
  }
  auto journal = execution::read_journal(*json);
  if (!journal) return tl::unexpected(std::move(journal).error());
  return of_journal(std::move(*journal));
}

Expected<Replayed> of_store(const std::string& data, const std::string& text) {
  ASSIGN_OR_RETURN(const RunId id, read_run_number(text, "RUN"));
  Replayed run;
  ASSIGN_OR_RETURN(run.store, Runs::open_to_read(data + "/race.sqlite"));
  ASSIGN_OR_RETURN(const RunRecord record, run.store->get(id));
  ASSIGN_OR_RETURN(run.header, run.store->header(id));
  ASSIGN_OR_RETURN(run.checkpoints, run.store->checkpoints(id));
  std::erase_if(run.checkpoints, [&](std::uint64_t position) { return position > record.steps; });  // a server goes on
  run.source = run.store->source(id);
  run.steps = record.steps;
  return run;
}

Checked<Replayed> open(const Options& options) {
  if (!options.data) return of_file(options.run);
  auto run = of_store(*options.data, options.run);
  if (!run) return tl::unexpected(std::vector<Error>{std::move(run).error()});
  return std::move(*run);
}

/// The journal's chain, and one over the derivations: of each macro step, as race derive prints it.
struct Hashes {
  sqlite::Digest chain, derivations = {};
};

// A stored checkpoint is what is recomputed, but for the inputs that waited: these come later in the journal, or had no
// effect.
Expected<void> check_checkpoint(const execution::Execution& execution, const Value& stored) {
  Value ours = execution::checkpoint_json(execution), theirs = stored;
  for (Value* each : {&ours, &theirs})
    if (each->is_dict()) each->mutable_dict().erase("waiting");
  if (ours == theirs) return {};
  return unexpected(ErrorCode::corrupt, "the stored checkpoint is not what the journal comes to",
                    "checkpoints/" + std::to_string(execution.run().position()));
}

/// Does the run again. Gives the derivation document, without steps if only hashes are wanted.
Expected<Value> derive(const Replayed& run, Hashes* hashes) {
  ASSIGN_OR_RETURN(execution::JournalWalk walk, execution::JournalWalk::create(run.header, run.source, run.steps));
  List steps;
  auto checkpoint = run.checkpoints.begin();
  while (!walk.at_end()) {
    ASSIGN_OR_RETURN(const execution::Progress* progress, walk.next({.derivation = true}));
    Value step = derived_step(walk.execution(), *progress);
    if (hashes) {
      hashes->chain = chain_after(hashes->chain, input_text(*progress->entry));
      hashes->derivations = sqlite::sha256_of({sqlite::bytes(hashes->derivations), to_json(step)});
    } else {
      steps.push_back(std::move(step));
    }
    if (checkpoint == run.checkpoints.end() || *checkpoint != progress->position) continue;
    ASSIGN_OR_RETURN(const Value stored, run.source->checkpoint(*checkpoint++));
    if (auto same = check_checkpoint(walk.execution(), stored); !same) return tl::unexpected(std::move(same).error());
  }
  if (checkpoint != run.checkpoints.end())
    return unexpected(ErrorCode::corrupt, "the journal does not come to the stored checkpoint",
                      "checkpoints/" + std::to_string(*checkpoint));
  Dict document{{"steps", std::move(steps)}};
  execution::set_status(walk.execution().run(), document);
  return Value(std::move(document));
}

int print_hashes(const Value& document, const Hashes& hashes, std::uint64_t steps) {
  std::printf("steps %llu\nchain %s\nderivations %s\n", static_cast<unsigned long long>(steps),
              sqlite::hex(hashes.chain).c_str(), sqlite::hex(hashes.derivations).c_str());
  return document.find("status")->as_string() == "faulted" ? kExitFindings : kExitOk;
}

int replay(const Options& options) {
  const bool json = !options.as_text && !options.hash;
  const auto run = open(options);
  const std::string file = options.data ? "" : options.run;
  if (!run) return refuse(FileErrors{file, run.error()}, json);
  Hashes hashes{header_chain(run->header)};
  const auto document = derive(*run, options.hash ? &hashes : nullptr);
  if (!document) return refuse(FileErrors{file, {document.error()}}, json);
  if (!run->checkpoints.empty())
    std::fprintf(stderr, "%zu stored checkpoints are what the journal comes to\n", run->checkpoints.size());
  if (options.hash) return print_hashes(*document, hashes, run->steps);
  return print_derivations(*document, options.as_text);
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.file("RUN", options->run);
  arguments.text("--data", "DIR", options->data, "the folder of a server that keeps the run; RUN is its number");
  arguments.flag("--text", options->as_text, "as a transcript: one node a line");
  arguments.flag("--hash", options->hash, "the hashes of the journal and of the derivations alone, to compare builds");
  return [options] { return replay(*options); };
}

}  // namespace

const Command kReplay = {"replay", "does a run again from its journal and prints its derivations", declare};

}  // namespace race::server
