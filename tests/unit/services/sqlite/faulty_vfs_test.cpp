// That the disk of the tests does what it says, and what the durability of our files rests on.
#include "tests/unit/services/sqlite/faulty_vfs.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <gmock/gmock.h>

#include "services/sqlite/file.h"
#include "tests/unit/temporary_folder.h"

namespace race::sqlite {
namespace {

struct FaultyVfsTest : testing::Test {
  TemporaryFolder disk, after;
  const std::string path = disk.file("rows.sqlite");

  void make_table() const { open(path)->exec("CREATE TABLE row (number INTEGER PRIMARY KEY, text TEXT NOT NULL)"); }
  static void insert(SQLite::Database& file, int number) {
    file.exec("INSERT INTO row VALUES (" + std::to_string(number) + ", hex(randomblob(700)))");
  }
  /// The rows that a server finds that begins on `after`; -1: no table.
  int rows_after() const {
    const auto file = open(after.file("rows.sqlite"));
    const auto sound = check(*file);
    EXPECT_TRUE(sound) << sound.error().message;
    if (!file->tableExists("row")) return -1;
    return file->execAndGet("SELECT count(*) FROM row").getInt();
  }
};

TEST_F(FaultyVfsTest, KeepsWhatWasSynchronised) {
  FaultyVfs vfs;
  make_table();
  const auto file = open(path);
  insert(*file, 1);
  vfs.lose_power(disk.path, after.path);
  EXPECT_EQ(rows_after(), 1);
}

TEST_F(FaultyVfsTest, LosesWhatWasNotSynchronised) {
  FaultyVfs vfs;
  make_table();
  const auto file = open(path);
  file->exec("PRAGMA synchronous = OFF");
  insert(*file, 1);
  vfs.lose_power(disk.path, after.path);
  EXPECT_EQ(rows_after(), 0);
  vfs.lose_power(disk.path, after.path, 1);
  EXPECT_EQ(rows_after(), 1) << "a crash of the process alone loses nothing";
}

TEST_F(FaultyVfsTest, MaySkipASynchronisation) {
  FaultyVfs vfs;
  make_table();
  const auto file = open(path);
  insert(*file, 1);
  vfs.skip_syncs(true);
  insert(*file, 2);
  vfs.lose_power(disk.path, after.path);
  EXPECT_EQ(rows_after(), 1);
}

TEST_F(FaultyVfsTest, FailsAtTheOperationOnceOrForEver) {
  FaultyVfs vfs;
  make_table();
  const auto file = open(path);
  vfs.fail_at(1, FaultyVfs::Fault::full, false);
  EXPECT_THROW(insert(*file, 1), SQLite::Exception);
  EXPECT_TRUE(vfs.has_failed());
  EXPECT_NO_THROW(insert(*file, 1));
  vfs.fail_at(1, FaultyVfs::Fault::io, true);
  EXPECT_THROW(insert(*file, 2), SQLite::Exception);
  EXPECT_THROW(insert(*file, 2), SQLite::Exception);
  vfs.repair();
  EXPECT_NO_THROW(insert(*file, 2));
}

TEST_F(FaultyVfsTest, CallsTheHookBeforeEachOperation) {
  FaultyVfs vfs;
  std::vector<std::uint64_t> seen;
  vfs.before_each([&](std::uint64_t operation) { seen.push_back(operation); });
  make_table();
  EXPECT_GT(seen.size(), 10U);
  EXPECT_EQ(seen.size(), vfs.operations());
  EXPECT_EQ(seen.back(), vfs.operations());
}

}  // namespace
}  // namespace race::sqlite
