// The writer of journals: what it says is durable survives a loss of power, what failed was never said, and cores that
// are busy at once share a commit.
#include "server/store/journal_writer.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <chrono>
#include <new>
#include <thread>

#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/server/bench.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"

namespace race::server {
namespace {

using execution::EventEntry;
using execution::StartEntry;

struct RecordingSink final : RunSink {
  void durable(std::uint64_t ticket) override {
    if (throws.exchange(false)) throw std::bad_alloc();
    last = ticket;
  }
  void stalled(const Error&) override { ++stalls; }
  void failed(const Error& error) override {
    code = error.code;
    ++failures;
  }
  std::atomic<std::uint64_t> last{0};
  std::atomic<int> failures{0}, stalls{0};
  std::atomic<ErrorCode> code{ErrorCode::io};
  std::atomic<bool> throws{false};
};

struct Writing {
  Writing(Runs& runs, JournalWriter& to)
      : run(runs.create({"small", 1, execution::small_journal().header, {}}, 0).value()),
        writer(to),
        journal(std::make_shared<RunJournal>(run, sink)) {}
  void append(execution::JournalEntry entry) {
    writer.append(journal, {.ticket = ++ticket, .entry = std::move(entry)});
  }
  void append_some(int count) {
    if (ticket == 0) append(StartEntry{});
    for (int i = 0; i < count; ++i) append(EventEntry{"t", "tick", i});
  }
  /// Whether all of it is durable; false if it has failed.
  bool settled() const {
    while (sink->last < ticket && sink->failures == 0) std::this_thread::sleep_for(std::chrono::microseconds(100));
    return sink->failures == 0;
  }
  RunRecord run;
  JournalWriter& writer;
  std::shared_ptr<RecordingSink> sink = std::make_shared<RecordingSink>();
  std::shared_ptr<RunJournal> journal;
  std::uint64_t ticket = 0;
};

TEST(JournalWriter, ContinuesTheChainThatReadersCheck) {
  TemporaryStore store;
  Writing writing(*store.runs, *store.writer);
  writing.append_some(5);
  ASSERT_TRUE(writing.settled());
  const auto program = execution::small_journal().header.program;
  const auto entries = store.runs->entries(writing.run.id, 1, 6);
  ASSERT_TRUE(entries) << to_string(entries.error());
  EXPECT_EQ(std::get<EventEntry>(entries->back()).data, Value(4));
  EXPECT_EQ(store.runs->get(writing.run.id)->status, "running");
}

TEST(JournalWriter, WritesWhatWaitsInOneCommit) {
  TemporaryStore store;
  std::vector<std::unique_ptr<Writing>> all;
  for (int i = 0; i < 10; ++i) all.push_back(std::make_unique<Writing>(*store.runs, *store.writer));
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  all.front()->append_some(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the writer stands in line with these
  for (const auto& each : all) each->append_some(9);
  busy.reset();
  for (const auto& each : all) ASSERT_TRUE(each->settled());
  const auto [commits, entries] = store.writer->commits();
  EXPECT_EQ(entries, 101U);
  EXPECT_LE(commits, 2U);
}

// The writer stands in line meanwhile; what it has stored at last is in the store.
TEST(JournalWriter, SaysThatTheDiskHangsAndThenThatTheJournalHasFailed) {
  TemporaryStore store;
  const auto writer = JournalWriter::open(store.folder.store(), std::chrono::milliseconds(40)).value();
  Writing writing(*store.runs, *writer);
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  writing.append_some(2);
  while (writing.sink->stalls == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(writing.sink->failures, 0) << "what is stored is not known yet";
  busy.reset();
  EXPECT_FALSE(writing.settled());
  EXPECT_EQ(writing.sink->last, 0U);
  const std::uint64_t stored = store.runs->get(writing.run.id)->steps;
  EXPECT_GE(stored, 1U);
  writing.append_some(1);
  writer->close();
  EXPECT_EQ(store.runs->get(writing.run.id)->steps, stored);
  EXPECT_EQ(writing.sink->stalls + writing.sink->failures, 2) << "each is said once";
}

// Its core may have appended more before it heard of the failure.
TEST(JournalWriter, AFailedJournalIsToldTheEndOfEachTimeThatTheDiskHangs) {
  sqlite::FaultyVfs disk;
  TemporaryStore store;
  const auto writer = JournalWriter::open(store.folder.store(), std::chrono::milliseconds(40)).value();
  Writing failed(*store.runs, *writer), other(*store.runs, *writer);
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  failed.append_some(1);
  EXPECT_FALSE(failed.settled());
  disk.repair();
  const int stalls = failed.sink->stalls, failures = failed.sink->failures;
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  other.append_some(1);
  failed.append_some(1);
  while (failed.sink->stalls == stalls || other.sink->stalls == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  busy.reset();
  EXPECT_FALSE(other.settled());
  while (failed.sink->failures == failures) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(store.runs->get(failed.run.id)->steps, 0U);
}

TEST(JournalWriter, WritesNothingOfARunThatIsNotInTheStoreAndTheOthersWhole) {
  TemporaryStore store;
  Writing lost(*store.runs, *store.writer), other(*store.runs, *store.writer);
  lost.append_some(1);
  ASSERT_TRUE(lost.settled());
  ASSERT_TRUE(store.runs->remove(lost.run.id));
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  other.append_some(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the writer stands in line with these
  lost.append_some(3);
  other.append_some(3);
  busy.reset();
  EXPECT_FALSE(lost.settled());
  EXPECT_EQ(lost.sink->code, ErrorCode::not_found);
  EXPECT_TRUE(other.settled());
  EXPECT_EQ(store.runs->get(other.run.id)->steps, 5U);
  EXPECT_EQ(file->execAndGet("SELECT count(*) FROM entry").getInt(), 5) << "all of the other run";
}

TEST(JournalWriter, AFullJournalTakesTheEndOfItsRunAlone) {
  TemporaryStore store;
  const auto writer = JournalWriter::open(store.folder.store(), DiskWatch::kTimeout, 1000).value();
  Writing full(*store.runs, *writer), other(*store.runs, *writer);
  int entries = 0;
  do {
    full.append_some(1);
    ++entries;
  } while (full.settled());
  EXPECT_EQ(full.sink->code, ErrorCode::too_large);
  RunRecord run = store.runs->get(full.run.id).value();
  EXPECT_EQ(run.steps, static_cast<std::uint64_t>(entries)) << "the start, and all ticks but the last";
  EXPECT_GE(run.bytes, 1000U);
  other.append_some(1);
  EXPECT_TRUE(other.settled());
  const auto sink = std::make_shared<RecordingSink>();
  writer->append(std::make_shared<RunJournal>(run, sink),
                 {.ticket = 1, .entry = execution::AbortEntry{}, .end = RunEnd{"aborted", "", {}, {}, 1}});
  while (sink->last == 0 && sink->failures == 0) std::this_thread::sleep_for(std::chrono::microseconds(100));
  EXPECT_EQ(store.runs->get(run.id).value().status, "aborted");
}

TEST(JournalWriter, AnExceptionFailsTheJournalsThatAreWrittenAndNoOthers) {
  TemporaryStore store;
  Writing first(*store.runs, *store.writer), second(*store.runs, *store.writer);
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  Writing* const both[] = {&first, &second};
  for (Writing* each : both) each->sink->throws = true;
  first.append_some(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the writer stands in line with these
  second.append_some(1);
  busy.reset();
  for (Writing* each : both) {
    EXPECT_FALSE(each->settled());
    EXPECT_EQ(each->sink->code, ErrorCode::storage);
    EXPECT_EQ(each->sink->failures, 1);
  }
  Writing third(*store.runs, *store.writer);
  third.append_some(3);
  EXPECT_TRUE(third.settled());
  EXPECT_GE(store.runs->get(first.run.id)->steps, 1U) << "what was committed stays";
}

TEST(JournalWriter, KeepsAFewCheckpointsOfALongRun) {
  EXPECT_EQ(RunJournal::interval_at(1), 1024U);
  EXPECT_EQ(RunJournal::interval_at(64 * 1024), 1024U);
  EXPECT_EQ(RunJournal::interval_at(64 * 1024 + 1), 2048U);
  EXPECT_EQ(RunJournal::interval_at(1'000'000), 16384U);
  for (std::uint64_t position = 1; position < 10'000'000; position += 997)
    ASSERT_LE(position / RunJournal::interval_at(position), RunJournal::kCheckpoints) << position;
}

TEST(JournalWriter, LeavesOutCheckpointsForWhichThereIsNoTime) {
  TemporaryStore store;
  Writing writing(*store.runs, *store.writer);
  writing.append_some(0);
  constexpr std::size_t kSize = JournalWriter::kMostCheckpointUnits / 8;
  const Value checkpoint = Value(Dict{{"large", std::string(kSize, 'x')}}).freeze();
  for (int i = 0; i < 30; ++i)
    store.writer->append(writing.journal,
                         {.ticket = ++writing.ticket, .entry = EventEntry{"t", "tick", i}, .checkpoint = checkpoint});
  EXPECT_TRUE(writing.settled());
  const RunRecord run = store.runs->get(writing.run.id).value();
  EXPECT_EQ(run.steps, 31U);
  EXPECT_GE(run.bytes, JournalWriter::kMostCheckpointUnits);
  EXPECT_LT(run.bytes, 2 * JournalWriter::kMostCheckpointUnits);
}

// At every operation of the disk: what was said to be durable is there after a loss of power.
TEST(JournalWriter, WhatItSaysIsDurableSurvivesALossOfPower) {
  sqlite::FaultyVfs disk;
  TemporaryStore store;
  TemporaryFolder copy;
  Writing first(*store.runs, *store.writer), second(*store.runs, *store.writer);
  const auto program = execution::small_journal().header.program;
  int looked = 0;
  const auto look = [&](std::uint64_t operation) {
    if (operation % 3 != 0) return;
    ++looked;
    disk.lose_power(store.place.path, copy.path, operation % 2 == 0 ? 0 : 0.5, operation);
    const auto runs = Runs::open(copy.path / "race.sqlite");
    ASSERT_TRUE(runs) << to_string(runs.error());
    for (const Writing* each : {&first, &second}) {
      const std::uint64_t said = each->sink->last;
      const auto run = (*runs)->get(each->run.id);
      ASSERT_TRUE(run) << to_string(run.error());
      ASSERT_GE(run->steps, said) << "operation " << operation;
      if (run->steps > 0) {
        ASSERT_TRUE((*runs)->entries(run->id, 1, run->steps));
      }
    }
  };
  disk.before_each(look);
  for (int i = 0; i < 20; ++i) {
    first.append_some(1);
    second.append_some(2);
    ASSERT_TRUE(first.settled() && second.settled());
  }
  disk.before_each(nullptr);
  EXPECT_GT(looked, 20);
}

TEST(JournalWriter, AfterAFailureNothingMoreIsWrittenToAJournalUntilItIsReadAgain) {
  sqlite::FaultyVfs disk;
  TemporaryStore store;
  const auto file = sqlite::open(store.folder.store());
  const auto program = execution::small_journal().header.program;
  for (const auto fault : {sqlite::FaultyVfs::Fault::full, sqlite::FaultyVfs::Fault::io})
    for (const bool for_ever : {false, true})
      for (std::uint64_t nth = 1; nth <= 6; ++nth) {
        SCOPED_TRACE("operation " + std::to_string(nth));
        Writing writing(*store.runs, *store.writer);
        writing.append_some(3);
        ASSERT_TRUE(writing.settled());
        disk.fail_at(nth, fault, for_ever);
        for (int i = 0; i < 4 && writing.sink->failures == 0; ++i) {
          writing.append_some(1);
          writing.settled();
        }
        const bool failed = disk.has_failed();
        disk.repair();
        const std::uint64_t said = writing.sink->last;
        if (failed) {
          EXPECT_EQ(writing.sink->failures, 1);
          EXPECT_EQ(writing.sink->code, ErrorCode::storage);
        }
        writing.append_some(2);  // of a run that has failed: dropped
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const RunRecord stored = store.runs->get(writing.run.id).value();
        if (failed) {
          EXPECT_EQ(stored.steps, said);
        }
        const auto sink = std::make_shared<RecordingSink>();
        store.writer->append(std::make_shared<RunJournal>(stored, sink),
                             {.ticket = 1, .entry = EventEntry{"t", "tick", 0}});
        while (sink->last == 0 && sink->failures == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_EQ(sink->last, 1U);
        EXPECT_EQ(file->execAndGet("PRAGMA wal_checkpoint(TRUNCATE)").getInt(), 0) << "a transaction was left open";
        EXPECT_TRUE(store.runs->entries(stored.id, 1, stored.steps + 1));
      }
}

}  // namespace
}  // namespace race::server
