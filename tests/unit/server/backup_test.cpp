// Backups: whole copies, made while others write; a damaged one is never brought back.
#include "server/store/backup.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <atomic>
#include <fstream>
#include <future>
#include <thread>

#include "server/store/data_folder.h"
#include "server/store/run_removal.h"
#include "server/store/runs.h"
#include "server/store/unfinished_folder.h"
#include "services/database/store.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

Expected<void> nothing() { return {}; }
Expected<void> never() {
  ADD_FAILURE() << "begun with a backup that is not sound";
  return {};
}

namespace fs = std::filesystem;
using sqlite::FaultyVfs;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t kTime = 1'795'357'864'123;  // 2026-11-22 14:31:04.123 UTC
constexpr const char* kName = "20261122T143104.123Z";

struct BackupTest : testing::Test {
  BackupTest() { EXPECT_TRUE(DataFolder::open(data)); }

  database::Store values() const { return database::Store::open(data / "database.sqlite").value(); }
  void put(const char* key, int value) const { ASSERT_TRUE(values().put(key, value)); }
  void fill(int mebibytes) const {
    auto store = values();
    for (int i = 0; i < mebibytes; ++i)
      ASSERT_TRUE(store.put("large" + std::to_string(i), std::string(std::size_t{1} << 20U, 'x')));
  }
  Value get(const char* key) const { return values().get(key).value_or(Value()); }
  std::vector<std::string> files_of_backups() const {
    std::vector<std::string> names;
    if (fs::exists(data / "backups"))
      for (const auto& entry : fs::directory_iterator(data / "backups")) names.push_back(entry.path().filename());
    return names;
  }

  const TemporaryFolder folder;
  const fs::path data = folder.file("data");
  Backups backups{data};
};

TEST_F(BackupTest, BringsBackWhatWasThere) {
  put("x", 1);
  const auto backup = backups.create(kTime);
  ASSERT_TRUE(backup) << to_string(backup.error());
  EXPECT_EQ(backup->name, kName);
  EXPECT_EQ(backup->created_ms, kTime);
  EXPECT_GT(backup->bytes, 8192U);
  put("x", 2);
  put("y", 3);
  auto open_meanwhile = values();
  ASSERT_TRUE(backups.restore(kName, nothing));
  EXPECT_EQ(open_meanwhile.get("x").value(), Value(1)) << "who has it open sees it too";
  EXPECT_THAT(open_meanwhile.keys("").value(), ElementsAre("x"));
  EXPECT_TRUE(open_meanwhile.put("z", 4));
  EXPECT_EQ(get("z"), Value(4));
  EXPECT_TRUE(DataFolder::open(data));
}

TEST_F(BackupTest, IsListedByTimeAndCanBeRemoved) {
  ASSERT_TRUE(backups.create(kTime));
  ASSERT_TRUE(backups.create(kTime - 1));
  const auto list = backups.list().value();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].name, "20261122T143104.122Z");
  EXPECT_EQ(list[1].name, kName);
  ASSERT_TRUE(backups.remove(kName));
  EXPECT_THAT(files_of_backups(), ElementsAre("20261122T143104.122Z"));
}

TEST_F(BackupTest, IsListedWhileAnotherIsMadeOrBroughtBack) {
  ASSERT_TRUE(backups.create(kTime));
  fs::create_directories(data / "backups" / "20261122T143104.124Z.unfinished");
  std::future<std::size_t> listed;
  const auto begin = [&]() -> Expected<void> {
    listed = std::async(std::launch::async, [&] { return backups.list().value().size(); });
    EXPECT_EQ(listed.wait_for(std::chrono::seconds(5)), std::future_status::ready);
    return {};
  };
  EXPECT_TRUE(backups.restore(kName, begin));
  EXPECT_EQ(listed.get(), 1U);
}

TEST_F(BackupTest, ThatIsNotThereIsNotFound) {
  for (const char* name : {kName, "", "..", "../backups", "20261322T143104.123Z", "x"}) {
    EXPECT_EQ(backups.remove(name).error().code, ErrorCode::not_found) << name;
    EXPECT_EQ(backups.restore(name, never).error().code, ErrorCode::not_found) << name;
  }
}

TEST_F(BackupTest, AreTwentyAtMost) {
  for (std::size_t i = 0; i < Backups::kMost; ++i) ASSERT_TRUE(backups.create(kTime + static_cast<int>(i)));
  EXPECT_EQ(backups.create(kTime + 1000).error().code, ErrorCode::conflict);
  ASSERT_TRUE(backups.remove(kName));
  EXPECT_TRUE(backups.create(kTime + 1000));
}

TEST_F(BackupTest, OfTheSameMillisecondIsAConflict) {
  ASSERT_TRUE(backups.create(kTime));
  EXPECT_EQ(backups.create(kTime).error().code, ErrorCode::conflict);
}

TEST_F(BackupTest, WithAnyByteChangedIsRefusedAndNothingIsChanged) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  put("x", 2);
  for (const char* name : {"race.sqlite", "database.sqlite", "digests.json"}) {
    const fs::path path = data / "backups" / kName / name;
    for (const std::uint64_t at : {std::uint64_t{5}, static_cast<std::uint64_t>(fs::file_size(path)) - 3}) {
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      file.seekg(static_cast<std::streamoff>(at));
      const char old = static_cast<char>(file.get());
      file.seekp(static_cast<std::streamoff>(at)) << static_cast<char>(old ^ 1) << std::flush;
      const auto refused = backups.restore(kName, never);
      ASSERT_FALSE(refused) << name;
      EXPECT_EQ(refused.error().code, ErrorCode::corrupt) << name;
      EXPECT_EQ(get("x"), Value(2));
      file.seekp(static_cast<std::streamoff>(at)) << old;
    }
  }
  EXPECT_TRUE(backups.restore(kName, nothing));
}

TEST_F(BackupTest, WithAFileLostIsRefused) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  fs::remove(data / "backups" / kName / "database.sqlite");
  EXPECT_EQ(backups.restore(kName, never).error().code, ErrorCode::io);
}

TEST_F(BackupTest, OfANewerVersionIsRefused) {
  SQLite::Database(data / "race.sqlite", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 1000");
  ASSERT_TRUE(backups.create(kTime));
  EXPECT_EQ(backups.restore(kName, never).error().code, ErrorCode::version);
}

TEST_F(BackupTest, IsOfOneMomentWhileValuesAreWritten) {
  std::atomic<bool> stop{false};
  std::jthread writer([&] {
    auto store = values();
    for (int i = 0; !stop; ++i)
      for (const char* key : {"first", "second"}) EXPECT_TRUE(store.put(key, i));
  });
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(backups.create(kTime + i));
  stop = true;
  writer.join();
  const auto all = backups.list().value();
  for (const Backup& backup : all) {
    ASSERT_TRUE(backups.restore(backup.name, nothing));
    const Value first = get("first"), second = get("second");
    if (first == Value()) continue;  // before the first value
    const std::int64_t behind = first.as_integer() - (second == Value() ? -1 : second.as_integer());
    EXPECT_TRUE(behind == 0 || behind == 1) << behind;
  }
}

TEST_F(BackupTest, IsMadeWhileAWriterNeverPauses) {
  fill(8);  // many times as much as is copied at once
  std::atomic<bool> stop{false};
  std::atomic<int> written{0};
  std::jthread writer([&] {
    auto store = values();
    for (; !stop; ++written) EXPECT_TRUE(store.put("x", written.load()));
  });
  while (written == 0) std::this_thread::yield();
  const auto backup = backups.create(kTime);
  stop = true;
  writer.join();
  EXPECT_TRUE(backup) << to_string(backup.error());
}

/// What is seen of some work by who looks at it again and again.
class Onlooker {
 public:
  explicit Onlooker(const WorkProgress& progress)
      : thread_([this, &progress] {
          while (!stop_) {
            look(progress);
            std::this_thread::yield();
          }
          look(progress);
        }) {}
  ~Onlooker() { seen(); }
  Onlooker(const Onlooker&) = delete;
  Onlooker& operator=(const Onlooker&) = delete;
  const std::vector<WorkProgress::State>& seen() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return seen_;
  }

 private:
  void look(const WorkProgress& progress) {
    const auto state = progress.state();
    if (state && (seen_.empty() || seen_.back().done != state->done)) seen_.push_back(*state);
  }
  std::atomic<bool> stop_{false};
  std::vector<WorkProgress::State> seen_;
  std::thread thread_;
};

/// Whether the work was seen on its way: within the first of three times that it goes through the files, and the last.
bool is_on_its_way(const std::vector<WorkProgress::State>& seen) {
  bool first = false, last = false;
  std::uint64_t before = 0;
  for (const auto& [done, total, unit] : seen) {
    EXPECT_GE(done, before);
    EXPECT_EQ(total, seen.front().total);
    EXPECT_STREQ(unit, "bytes");
    first = first || (0 < done && done < total / 3);
    last = last || (total / 3 * 2 < done && done < total);
    before = done;
  }
  EXPECT_EQ(before, seen.front().total);
  return first && last;
}

TEST_F(BackupTest, SaysHowFarItIsAndSoDoesItsRestore) {
  constexpr int kTries = 10;  // who looks may be too late, but not each time
  fill(16);
  bool making = false, restoring = false;
  for (int tries = 0; tries < kTries && !(making && restoring); ++tries) {
    WorkProgress made, restored;
    Onlooker at_backup(made);
    const auto backup = backups.create(kTime + tries, &made);
    ASSERT_TRUE(backup);
    making = is_on_its_way(at_backup.seen()) || making;
    Onlooker at_restore(restored);
    ASSERT_TRUE(backups.restore(backup->name, nothing, &restored));
    restoring = is_on_its_way(at_restore.seen()) || restoring;
  }
  EXPECT_TRUE(making);
  EXPECT_TRUE(restoring);
}

TEST_F(BackupTest, HasTwoThirdsOfItsRestoreBehindItWhenItBegins) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  WorkProgress progress;
  ASSERT_TRUE(backups.restore(
      kName,
      [&] {
        EXPECT_EQ(progress.state()->done, progress.state()->total / 3 * 2);
        return nothing();
      },
      &progress));
  EXPECT_EQ(progress.state()->done, progress.state()->total);
}

TEST_F(BackupTest, EndsWithTheServerAndLeavesNothing) {
  ASSERT_TRUE(backups.create(kTime));
  backups.stop();
  EXPECT_EQ(backups.create(kTime + 1).error().code, ErrorCode::unavailable);
  EXPECT_THAT(files_of_backups(), ElementsAre(kName));
  EXPECT_EQ(backups.restore(kName, never).error().code, ErrorCode::unavailable);
}

TEST_F(BackupTest, ThatCannotBeWrittenLeavesNothing) {
  put("x", 1);
  bool failed = true;
  for (std::uint64_t nth = 1; failed; ++nth) {
    FaultyVfs vfs;
    vfs.fail_at(nth, FaultyVfs::Fault::full, true);
    const auto backup = backups.create(kTime);
    failed = vfs.has_failed();
    ASSERT_EQ(backup.has_value(), !failed) << nth;
    if (failed) {
      EXPECT_EQ(backup.error().code, ErrorCode::storage) << to_string(backup.error());
      EXPECT_THAT(files_of_backups(), IsEmpty());
    }
  }
}

TEST_F(BackupTest, ThatCannotBeBroughtBackLeavesTheValuesWhole) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  put("x", 2);
  bool failed = true;
  for (std::uint64_t nth = 1; failed; ++nth) {
    FaultyVfs vfs;
    vfs.fail_at(nth, FaultyVfs::Fault::full, true);
    const auto restored = backups.restore(kName, nothing);
    failed = vfs.has_failed();
    vfs.repair();
    ASSERT_TRUE(restored || restored.error().code == ErrorCode::storage) << to_string(restored.error());
    const Value x = get("x");
    EXPECT_TRUE(x == Value(1) || (!restored && x == Value(2))) << nth;
  }
}

TEST_F(BackupTest, ThatACrashHasLeftInPartIsRemoved) {
  for (const char* suffix : {".unfinished", ".unfinished-1-1"})
    fs::create_directories(data / "backups" / (std::string(kName) + suffix));
  EXPECT_THAT(backups.list().value(), IsEmpty());
  const Backups again(data);
  EXPECT_THAT(files_of_backups(), IsEmpty());
}

TEST_F(BackupTest, ThatAnotherProcessIsMakingIsLeftAlone) {
  fs::create_directories(data / "backups");
  auto other = UnfinishedFolder::create(data / "backups" / kName);
  ASSERT_TRUE(other) << to_string(other.error());
  const Backups again(data);
  EXPECT_TRUE(fs::exists(other->path()));
  ASSERT_TRUE(backups.create(kTime)) << "of the same millisecond";
  EXPECT_EQ(other->finish().error().code, ErrorCode::conflict);
  EXPECT_THAT(backups.list().value(), testing::SizeIs(1));
}

TEST_F(BackupTest, IsBroughtBackWhenWhatWaitsIsWritten) {
  std::vector<std::string> calls;
  Backups used(data, {.flush =
                          [&] {
                            calls.push_back("flush");
                            put("x", 2);
                          },
                      .restored =
                          [&] {
                            calls.push_back("restored");
                            return nothing();
                          }});
  put("x", 1);
  ASSERT_TRUE(used.create(kTime));
  ASSERT_TRUE(used.restore(kName, [&] {
    calls.push_back("begin");
    return nothing();
  }));
  EXPECT_THAT(calls, ElementsAre("begin", "flush", "restored"));
  EXPECT_EQ(get("x"), Value(1));
}

TEST_F(BackupTest, DoesNotBringBackNumbersOfRuns) {
  const auto runs = Runs::open(data / "race.sqlite").value();
  const auto next = [&] { return runs->create({"r", 1, execution::small_journal().header, {}}, 1)->id; };
  EXPECT_EQ(next(), 1U);
  ASSERT_TRUE(backups.create(kTime));
  EXPECT_EQ(next(), 2U);
  ASSERT_TRUE(backups.restore(kName, [&] {
    EXPECT_EQ(next(), 3U);
    return nothing();
  }));
  EXPECT_EQ(runs->list(0, 10)->runs.size(), 1U);
  EXPECT_EQ(next(), 4U);
  ASSERT_TRUE(backups.restore(kName, nothing));
  EXPECT_EQ(Runs::open(data / "race.sqlite").value()->create({"r", 1, execution::small_journal().header, {}}, 1)->id,
            5U);
}

TEST_F(BackupTest, FinishesTheRemovalOfARunThatWasUnderWay) {
  const fs::path store = data / "race.sqlite";
  const auto runs = Runs::open(store).value();
  const RunId run = runs->create({"r", 1, execution::small_journal().header, {}}, 1)->id;
  SQLite::Database file(store, SQLite::OPEN_READWRITE);
  begin_removal(file, run);
  file.exec("DELETE FROM run; INSERT INTO sampling VALUES (1, 1, 1, 1)");
  ASSERT_TRUE(backups.create(kTime));
  ASSERT_TRUE(backups.restore(kName, nothing));
  EXPECT_EQ(file.execAndGet("SELECT (SELECT count(*) FROM removal) + (SELECT count(*) FROM sampling)").getInt(), 0);
}

TEST_F(BackupTest, LeavesFilesAloneThatItDoesNotReplaceOrThatAreSound) {
  ASSERT_TRUE(backups.create(kTime));
  std::ofstream(data / "database.sqlite") << std::string(8192, 'x');
  ASSERT_TRUE(set_damaged_aside(data, data / "backups" / kName, kTime));
  EXPECT_EQ(fs::file_size(data / "database.sqlite"), 8192U);
  for (const auto& entry : fs::directory_iterator(data))
    EXPECT_EQ(entry.path().string().find("damaged"), std::string::npos) << entry.path();
}

TEST_F(BackupTest, TakesNoPlaceOfAFileThatTheDiskDoesNotGive) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  FaultyVfs vfs;
  vfs.fail_at(1, FaultyVfs::Fault::io, true);
  const auto refused = set_damaged_aside(data, data / "backups" / kName, kTime);
  vfs.repair();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().code, ErrorCode::corrupt);
  EXPECT_EQ(get("x"), Value(1));
}

TEST_F(BackupTest, TakesThePlaceOfADamagedFileWhichIsKept) {
  put("x", 1);
  ASSERT_TRUE(backups.create(kTime));
  std::ofstream(data / "database.sqlite") << std::string(8192, 'x');
  std::ofstream(data / "database.sqlite-wal") << "log";
  ASSERT_TRUE(restore_files(data / "backups" / kName, data,
                            [&] { return set_damaged_aside(data, data / "backups" / kName, kTime); }));
  EXPECT_EQ(fs::file_size(data / ("database.sqlite.damaged-" + std::string(kName))), 8192U);
  EXPECT_EQ(fs::file_size(data / ("database.sqlite.damaged-" + std::string(kName) + "-wal")), 3U);
  EXPECT_EQ(get("x"), Value(1));
}

}  // namespace
}  // namespace race::server
