// Import and removal of runs: in short transactions, between which others write; what is interrupted leaves nothing.
#include <SQLiteCpp/Database.h>

#include <atomic>
#include <stop_token>
#include <thread>

#include "server/store/run_removal.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/run_store.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"

namespace race::server {
namespace {

using sqlite::FaultyVfs;

/// Entries of a journal that needs `blocks` transactions and a little more.
execution::Journal blocks(std::size_t blocks) { return counting(std::vector<int>(blocks * kRunRowsAtOnce, 0)); }

/// An import takes some hundredths of a second: who is to come in between may be too late, but not each time.
constexpr int kTries = 50;

class RunImport : public StoredRuns {
 protected:
  RunRecord import_whole(Runs& runs, const execution::Journal& journal) const {
    return import_with_checkpoint(runs, journal).value();
  }
  static Expected<RunRecord> import_with_checkpoint(Runs& runs, const execution::Journal& journal) {
    RunRecord record;
    record.status = "aborted";
    return runs.import(record, run_of(journal), journal.entries, {{1, "{}"}, {2, "{}"}});
  }
  std::int64_t count(const std::string& table) const {
    SQLite::Database file(path(), SQLite::OPEN_READONLY);
    return file.execAndGet("SELECT count(*) FROM " + table).getInt64();
  }
  /// After the store was opened again: all of the run, or nothing.
  bool is_whole_or_gone(RunId id, const execution::Journal& journal) const {
    const auto runs = open();
    EXPECT_EQ(count("removal"), 0);
    const auto run = runs->get(id);
    if (!run) {
      EXPECT_EQ(run.error().code, ErrorCode::not_found);
      for (const char* table : {"run", "entry", "checkpoint", "header"}) EXPECT_EQ(count(table), 0) << table;
      return false;
    }
    EXPECT_EQ(run->steps, journal.entries.size());
    EXPECT_TRUE(runs->entries(id, 1, run->steps));
    EXPECT_EQ(runs->checkpoints(id)->size(), 2U);
    return true;
  }
};

/// Another writer of the store, turn by turn, which looks at how many entries there are.
class Observer {
 public:
  Observer(const std::string& path, std::int64_t all) : file_(sqlite::open(path)), thread_([this, all] { run(all); }) {}
  bool saw_a_part() {
    stop_ = true;
    thread_.join();
    return part_;
  }

 private:
  void run(std::int64_t all) {
    while (!stop_) {
      sqlite::WriteTransaction transaction(*file_);
      const std::int64_t entries = file_->execAndGet("SELECT count(*) FROM entry").getInt64();
      part_ = part_ || (0 < entries && entries < all);
      transaction.commit();
    }
  }
  const std::unique_ptr<SQLite::Database> file_;
  std::atomic<bool> stop_{false}, part_{false};
  std::thread thread_;
};

TEST_F(RunImport, SaysHowManyEntriesAreStored) {
  const auto runs = open();
  const auto journal = blocks(8);
  const std::uint64_t all = journal.entries.size();
  bool on_its_way = false;
  for (int tries = 0; tries < kTries && !on_its_way; ++tries) {
    WorkProgress progress;
    progress.begin(2 * all, "entries");
    std::atomic<bool> over{false};
    std::thread onlooker([&] {
      while (!over) {
        const std::uint64_t done = progress.state()->done;
        on_its_way = on_its_way || (all < done && done < 2 * all);
      }
    });
    RunRecord record;
    record.status = "aborted";
    EXPECT_TRUE(runs->import(record, run_of(journal), journal.entries, {}, {}, {&progress, all, all}));
    over = true;
    onlooker.join();
    EXPECT_EQ(progress.state()->done, 2 * all);
  }
  EXPECT_TRUE(on_its_way);
}

TEST_F(RunImport, LetsOthersWriteBetweenItsTransactions) {
  const auto runs = open();
  const auto journal = blocks(8);
  const auto all = static_cast<std::int64_t>(journal.entries.size());
  bool while_importing = false, while_removing = false;
  for (int tries = 0; tries < kTries && !(while_importing && while_removing); ++tries) {
    Observer importing(path(), all);
    const RunId id = import_whole(*runs, journal).id;
    while_importing = importing.saw_a_part() || while_importing;
    ASSERT_TRUE(is_whole_or_gone(id, journal));
    Observer removing(path(), all);
    ASSERT_TRUE(runs->remove(id));
    while_removing = removing.saw_a_part() || while_removing;
    ASSERT_FALSE(is_whole_or_gone(id, journal));
  }
  EXPECT_TRUE(while_importing);
  EXPECT_TRUE(while_removing);
}

// At every operation of the disk.
TEST_F(RunImport, ThatFailsLeavesNothing) {
  FaultyVfs disk;
  const auto journal = blocks(1);
  RunId last = 0;
  bool failed = true;
  for (std::uint64_t nth = 1; failed; nth += 1 + nth / 8) {
    SCOPED_TRACE("operation " + std::to_string(nth));
    auto runs = open();
    disk.fail_at(nth, FaultyVfs::Fault::full, true);
    const auto run = import_with_checkpoint(*runs, journal);
    failed = disk.has_failed();
    disk.repair();
    runs.reset();
    EXPECT_TRUE(run || run.error().code == ErrorCode::storage);
    EXPECT_EQ(is_whole_or_gone(last + 1, journal) || is_whole_or_gone(last + 2, journal), run.has_value());
    runs = open();
    ASSERT_TRUE(!run || runs->remove(run->id));
    const RunId next = runs->create(run_of(journal), 1)->id;
    EXPECT_GT(next, run ? run->id : last) << "no number is used twice";
    last = next;
    ASSERT_TRUE(runs->remove(next));
  }
}

TEST_F(RunImport, ARemovalThatFailsIsFinishedWhenTheStoreIsOpened) {
  FaultyVfs disk;
  const auto journal = blocks(1);
  bool failed = true;
  for (std::uint64_t nth = 1; failed; nth += 1 + nth / 8) {
    SCOPED_TRACE("operation " + std::to_string(nth));
    auto runs = open();
    const RunId id = import_whole(*runs, journal).id;
    disk.fail_at(nth, FaultyVfs::Fault::full, true);
    const auto removed = runs->remove(id);
    failed = disk.has_failed();
    disk.repair();
    const bool was_there = runs->get(id).has_value();
    runs.reset();
    EXPECT_EQ(is_whole_or_gone(id, journal), was_there) << "one that is gone comes back";
    EXPECT_FALSE(removed && was_there);
    ASSERT_TRUE(!was_there || open()->remove(id));
  }
}

TEST_F(RunImport, EndsIfTheStoreBecomesAnotherMeanwhile) {
  const auto runs = open();
  const auto journal = blocks(8);
  const auto all = static_cast<std::int64_t>(journal.entries.size());
  std::atomic<bool> importing = true;  // a removal has a part of the entries, too, which is nobody's conflict
  std::jthread other([&, file = sqlite::open(path())](const std::stop_token& end) {
    for (bool deleted = false; !deleted && !end.stop_requested();) {
      sqlite::WriteTransaction transaction(*file);
      const std::int64_t entries = file->execAndGet("SELECT count(*) FROM entry").getInt64();
      deleted = importing && 0 < entries && entries < all;
      if (deleted) file->exec("DELETE FROM entry; DELETE FROM removal");
      transaction.commit();
    }
  });
  auto run = import_with_checkpoint(*runs, journal);
  for (int tries = 1; run && tries < kTries; ++tries) {
    importing = false;
    ASSERT_TRUE(runs->remove(run->id));
    importing = true;
    run = import_with_checkpoint(*runs, journal);
  }
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::conflict);
  EXPECT_FALSE(is_whole_or_gone(1, journal));
}

TEST_F(RunImport, ADamagedNameInTheTableOfRemovalsRemovesNothing) {
  const auto journal = blocks(0);
  const RunId id = import_whole(*open(), journal).id;
  sqlite::open(path())->exec("INSERT INTO removal SELECT id, x'00' FROM run");
  open();
  sqlite::open(path())->exec("DELETE FROM removal");
  EXPECT_TRUE(is_whole_or_gone(id, journal));
  {
    const auto file = sqlite::open(path());
    sqlite::WriteTransaction transaction(*file);
    begin_removal(*file, id);
    transaction.commit();
  }
  open();
  sqlite::open(path())->exec("DELETE FROM removal");
  EXPECT_TRUE(is_whole_or_gone(id, journal)) << "a run that is there is not being removed";
}

}  // namespace
}  // namespace race::server
