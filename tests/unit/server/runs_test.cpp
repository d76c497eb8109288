// The store of runs: what is read is what was written, and damage is named.
#include "server/store/runs.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/execution/checkpoint.h"
#include "core/execution/replay.h"
#include "core/rsm/document.h"
#include "core/value/json.h"
#include "server/store/journal_chain.h"
#include "server/store/run_checkpoints.h"
#include "server/store/run_row.h"
#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;
using execution::Journal;
using execution::JournalEntry;

class RunStore : public StoredRuns {
 protected:
  int change(const std::string& statement) const {
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    return file.exec(statement);
  }
  std::int64_t count(const std::string& table) const {
    SQLite::Database file(path(), SQLite::OPEN_READONLY);
    return file.execAndGet("SELECT count(*) FROM " + table).getInt64();
  }

  const Journal journal_ = execution::small_journal();
};

sqlite::Digest chain_of(const Journal& journal) {
  sqlite::Digest chain = header_chain(journal.header);
  for (const JournalEntry& entry : journal.entries) chain = chain_after(chain, input_text(entry));
  return chain;
}

std::vector<RunId> numbers_of(const std::vector<RunRecord>& runs) {
  std::vector<RunId> numbers;
  for (const RunRecord& run : runs) numbers.push_back(run.id);
  return numbers;
}

void expect_same(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(sqlite::hex(digest_of(a)), sqlite::hex(digest_of(b)));
}

TEST_F(RunStore, GivesARunANumberAndKeepsWhatItIs) {
  const RunRecord created = open()->create(run_of(journal_), 1700000000123).value();
  EXPECT_EQ(created.id, 1u);
  EXPECT_EQ(created.status, "ready");
  EXPECT_EQ(created.created_ms, 1700000000123);
  EXPECT_EQ(created.steps, 0u);
  EXPECT_EQ(created.chain, header_chain(journal_.header));
  const auto runs = open();
  expect_same(runs->get(1).value(), created);
  EXPECT_EQ(to_json(execution::header_json(runs->header(1).value())), to_json(execution::header_json(journal_.header)));
  EXPECT_EQ(runs->services(1).value(), Value(Dict{{"t", rsm::write_service(timer_service())}}));
}

TEST_F(RunStore, NeverUsesANumberAgain) {
  const auto runs = open();
  EXPECT_EQ(runs->create(run_of(journal_), 1)->id, 1u);
  EXPECT_EQ(runs->create(run_of(journal_), 2)->id, 2u);
  ASSERT_TRUE(runs->remove(2));
  EXPECT_EQ(open()->create(run_of(journal_), 3)->id, 3u);
}

TEST_F(RunStore, KnowsNoOtherNumber) {
  const auto runs = open();
  EXPECT_EQ(runs->get(1).error().code, ErrorCode::not_found);
  EXPECT_EQ(runs->get(~std::uint64_t{0}).error().code, ErrorCode::not_found);
  EXPECT_EQ(runs->remove(1).error().code, ErrorCode::not_found);
  EXPECT_EQ(runs->set_status(1, "running").error().code, ErrorCode::not_found);
  EXPECT_EQ(runs->source(1)->entries(1, 1).error().code, ErrorCode::not_found);
}

TEST_F(RunStore, ListsTheNewestFirst) {
  const auto runs = open();
  for (int i = 0; i < 5; ++i) runs->create(run_of(journal_, i % 2 == 0 ? "even" : "odd"), i).value();
  const auto numbers = [&](RunId before, std::size_t most, const std::string& document) {
    return numbers_of(runs->list(before, most, document)->runs);
  };
  EXPECT_EQ(numbers(0, 10, ""), (std::vector<RunId>{5, 4, 3, 2, 1}));
  EXPECT_EQ(numbers(4, 2, ""), (std::vector<RunId>{3, 2}));
  EXPECT_EQ(numbers(0, 10, "odd"), (std::vector<RunId>{4, 2}));
  EXPECT_EQ(numbers(1, 10, ""), (std::vector<RunId>{}));
}

TEST_F(RunStore, HostsAgainWhatIsNotOverAndWasNotImported) {
  const auto runs = open();
  for (const char* status : {"ready", "running", "interrupted", "ended", "faulted", "aborted"})
    ASSERT_TRUE(runs->set_status(runs->create(run_of(journal_), 1)->id, status));
  RunRecord record;
  record.status = "running";
  runs->import(record, run_of(journal_), {}).value();
  EXPECT_EQ(numbers_of(runs->open_runs()->runs), (std::vector<RunId>{1, 2, 3}));
}

TEST_F(RunStore, ReplacesTheHeaderOfARunThatHasNotBegun) {
  const auto runs = open();
  const RunRecord first = runs->create(run_of(journal_), 1).value();
  Journal other = journal_;
  other.header.arguments = Dict{{"key", "c"}};
  other.header.arguments.freeze();
  const RunRecord second = runs->replace(1, run_of(other, "other")).value();
  EXPECT_NE(second.chain, first.chain);
  EXPECT_EQ(second.document, "other");
  expect_same(runs->get(1).value(), second);
  EXPECT_EQ(runs->header(1)->arguments, other.header.arguments);
}

TEST_F(RunStore, SharesHeadersAndRemovesThemWithTheLastRun) {
  const auto runs = open();
  Journal other = journal_;
  other.header.arguments = Dict{{"key", "c"}};  // arguments are not shared
  runs->create(run_of(journal_), 1).value();
  runs->create(run_of(other), 2).value();
  EXPECT_EQ(count("header"), 2);
  ASSERT_TRUE(runs->remove(1));
  EXPECT_EQ(count("header"), 2);
  ASSERT_TRUE(runs->remove(2));
  EXPECT_EQ(count("header"), 0);
}

TEST_F(RunStore, RemovesARunWithItsJournal) {
  const auto runs = open();
  const RunId id = import(*runs, journal_).id;
  {
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    Statements statements(file);
    write_checkpoint(statements, id, checkpoint_row(id, 2, "{}"));
  }
  ASSERT_TRUE(runs->remove(id));
  for (const char* table : {"run", "entry", "checkpoint", "header"}) EXPECT_EQ(count(table), 0) << table;
}

TEST_F(RunStore, ReadsAnyPartOfAJournal) {
  const auto runs = open();
  const RunRecord run = import(*runs, journal_);
  EXPECT_TRUE(run.imported);
  EXPECT_EQ(run.steps, journal_.entries.size());
  EXPECT_EQ(run.chain, chain_of(journal_));
  expect_same(runs->get(run.id).value(), run);
  for (std::size_t from = 1; from <= run.steps; ++from)
    for (std::size_t to = from; to <= run.steps; ++to)
      EXPECT_EQ(runs->entries(run.id, from, to).value(),
                std::vector(journal_.entries.begin() + static_cast<std::ptrdiff_t>(from - 1),
                            journal_.entries.begin() + static_cast<std::ptrdiff_t>(to)));
  EXPECT_EQ(runs->entries(run.id, 1, run.steps + 1).error().code, ErrorCode::out_of_range);
}

TEST_F(RunStore, IsReplayed) {
  const auto runs = open();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    auto [journal, execution] = execution::random_journal(seed, 30);
    const RunRecord run = import(*runs, journal);
    const execution::JournalHeader header = runs->header(run.id).value();
    execution::Replay replay(header, runs->source(run.id), 4);
    execution::Replay expected(journal.header, std::make_shared<execution::MemoryJournal>(journal.entries));
    ASSERT_EQ(Value(replay.steps(1, run.steps, 0, -1).value()), Value(expected.steps(1, run.steps, 0, -1).value()));
  }
}

TEST_F(RunStore, ReadsTheNewestCheckpointBeforeAPosition) {
  const auto runs = open();
  auto [journal, execution] = execution::random_journal(3, 40);
  const RunRecord run = import(*runs, journal);
  execution::Replay replay(journal.header, std::make_shared<execution::MemoryJournal>(journal.entries));
  std::vector<Value> checkpoints;
  {
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    Statements statements(file);
    for (const std::uint64_t position : {2u, 4u}) {
      checkpoints.push_back(checkpoint_json(replay.after(position).value()));
      write_checkpoint(statements, run.id, checkpoint_row(run.id, position, to_json(checkpoints.back())));
    }
  }
  EXPECT_TRUE(runs->checkpoint(run.id, 1)->is_unknown());
  EXPECT_EQ(runs->checkpoint(run.id, 2).value(), checkpoints[0]);
  EXPECT_EQ(runs->checkpoint(run.id, 3).value(), checkpoints[0]);
  EXPECT_EQ(runs->checkpoint(run.id, 9).value(), checkpoints[1]);
  EXPECT_TRUE(execution::read_checkpoint(runs->header(run.id).value(), runs->checkpoint(run.id, 9).value()));
}

// ---- Damage.

struct Damage {
  std::string statement;
  std::string path;  // of the error
};

class DamagedRunStore : public RunStore {
 protected:
  // What reads everything of run 1.
  Expected<void> read_all() const {
    const auto runs = open();
    ASSIGN_OR_RETURN(const RunRecord run, runs->get(1));
    ASSIGN_OR_RETURN(const execution::JournalHeader header, runs->header(1));
    ASSIGN_OR_RETURN(const Value services, runs->services(1));
    ASSIGN_OR_RETURN(const std::vector<JournalEntry> entries, runs->entries(1, 1, run.steps));
    ASSIGN_OR_RETURN(const Value checkpoint, runs->checkpoint(1, run.steps));
    return {};
  }
  void store() const {
    const auto runs = open();
    import(*runs, journal_);
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    Statements statements(file);
    write_checkpoint(statements, 1, checkpoint_row(1, 3, "{}"));
  }
  void expect_named(const Damage& damage) const {
    SCOPED_TRACE(damage.statement);
    fs::remove(path());
    fs::remove(path() + "-wal");
    fs::remove(path() + "-shm");
    store();
    ASSERT_TRUE(read_all());
    ASSERT_GT(change(damage.statement), 0);
    const auto read = read_all();
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
    EXPECT_EQ(read.error().path, damage.path);
    ASSERT_TRUE(open()->remove(1));
  }
};

TEST_F(DamagedRunStore, NamesARunOfWhichAnyFieldIsDamaged) {
  for (const char* field :
       {"revision = 4", "document = 'tasl'", "header = services", "services = x'00'", "arguments = '{}'",
        "status = 'ended'", "outcome = 'x'", "fault = '{}'", "results = '1'", "steps = 5", "chain = digest",
        "created = 7", "ended = 7", "imported = 0", "bytes = 1", "digest = chain", "arguments = '{'"})
    expect_named({"PRAGMA foreign_keys = OFF; UPDATE run SET " + std::string(field), "runs/1"});
}

TEST_F(DamagedRunStore, NamesARunWhoseRowIsLost) {
  expect_named({"PRAGMA foreign_keys = OFF; DELETE FROM run", "runs/1"});
  expect_named({"UPDATE run SET id = 65", "runs/1"});
}

TEST_F(DamagedRunStore, ListsTheOthersBesideRunsThatAreDamaged) {
  const auto runs = open();
  for (int i = 0; i < 4; ++i) runs->create(run_of(journal_), i).value();
  import(*runs, journal_);
  ASSERT_TRUE(runs->set_status(4, "ended"));
  ASSERT_TRUE(runs->set_status(4, "interrupted"));
  EXPECT_EQ(runs->get(4)->status, "ended");
  change("UPDATE run SET outcome = 'x' WHERE id IN (2, 4)");
  change("PRAGMA foreign_keys = OFF; DELETE FROM run WHERE id = 5");
  const auto paths = [](const RunList& list) {
    std::vector<std::string> paths;
    for (const Error& error : list.errors()) paths.push_back(to_string(error).substr(0, 15));
    return paths;
  };
  const RunList hosted = runs->open_runs().value();
  EXPECT_EQ(numbers_of(hosted.runs), (std::vector<RunId>{1, 3}));
  EXPECT_EQ(paths(hosted), (std::vector<std::string>{"runs/2: corrupt", "runs/4: corrupt", "runs/5: corrupt"}));
  EXPECT_FALSE(hosted.damaged[0].is_over);
  EXPECT_TRUE(hosted.damaged[1].is_over);
  const RunList first = runs->list(0, 3).value(), rest = runs->list(first.next.value(), 3).value();
  EXPECT_EQ(numbers_of(first.runs), (std::vector<RunId>{3}));
  EXPECT_EQ(paths(first), (std::vector<std::string>{"runs/4: corrupt", "runs/2: corrupt", "runs/5: corrupt"}));
  EXPECT_EQ(numbers_of(rest.runs), (std::vector<RunId>{1}));
  EXPECT_FALSE(rest.next);
}

TEST_F(DamagedRunStore, NamesARunWhoseHeaderOrServicesAreDamaged) {
  expect_named({"UPDATE header SET text = replace(text, 'Root', 'Rooo') WHERE text LIKE '%native%'", "runs/1"});
  expect_named({"UPDATE header SET text = replace(text, 'tick', 'tock') WHERE text NOT LIKE '%native%'", "runs/1"});
  expect_named({"PRAGMA foreign_keys = OFF; DELETE FROM header WHERE text LIKE '%native%'", "runs/1"});
}

TEST_F(DamagedRunStore, NamesTheFirstEntryThatIsWrongMissingOrTooMuch) {
  expect_named(
      {"UPDATE entry SET input = replace(input, '\"call\":1', '\"call\":3') WHERE position = 2", "runs/1/entries/2"});
  expect_named({"UPDATE entry SET input = input || ' ' WHERE position = 4", "runs/1/entries/4"});
  expect_named({"UPDATE entry SET chain = zeroblob(32) WHERE position = 1", "runs/1/entries/1"});
  expect_named({"UPDATE entry SET chain = 'x' WHERE position = 6", "runs/1/entries/6"});
  expect_named({"DELETE FROM entry WHERE position = 1", "runs/1/entries/1"});
  expect_named({"DELETE FROM entry WHERE position = 4", "runs/1/entries/4"});
  expect_named({"DELETE FROM entry WHERE position = 6", "runs/1/entries/6"});
  expect_named({"UPDATE entry SET position = 70 WHERE position = 6", "runs/1/entries/6"});
  expect_named({"INSERT INTO entry SELECT run, 7, input, chain FROM entry WHERE position = 6", "runs/1/entries/7"});
  expect_named({"INSERT INTO entry SELECT run, -1, input, chain FROM entry WHERE position = 6", "runs/1/entries/-1"});
}

TEST_F(DamagedRunStore, NamesACheckpoint) {
  expect_named({"UPDATE checkpoint SET text = '{ }'", "runs/1/checkpoints/3"});
  expect_named({"UPDATE checkpoint SET position = 2", "runs/1/checkpoints/2"});
  expect_named({"UPDATE checkpoint SET digest = zeroblob(32)", "runs/1/checkpoints/3"});
}

TEST_F(DamagedRunStore, NamesEntriesThatWereExchangedWithTheirChains) {
  expect_named(
      {"UPDATE entry SET position = 60 - position WHERE position IN (3, 5);"
       "UPDATE entry SET position = position - 52 WHERE position = 55;"
       "UPDATE entry SET position = position - 52 WHERE position = 57",
       "runs/1/entries/3"});
}

TEST_F(RunStore, StoresADamagedHeaderAgain) {
  const auto runs = open();
  runs->create(run_of(journal_), 1).value();
  change("UPDATE header SET text = 'x'");
  EXPECT_EQ(runs->header(1).error().code, ErrorCode::corrupt);
  runs->create(run_of(journal_), 2).value();
  EXPECT_TRUE(runs->header(1));
}

}  // namespace
}  // namespace race::server
