#include "services/sqlite/file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <thread>

#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/temporary_folder.h"

namespace race::sqlite {
namespace {

void make_row(SQLite::Database& file) { file.exec("CREATE TABLE row (number INTEGER PRIMARY KEY)"); }
void add_text(SQLite::Database& file) { file.exec("ALTER TABLE row ADD COLUMN text TEXT NOT NULL DEFAULT 'old'"); }
void fail_half_way(SQLite::Database& file) {
  file.exec("ALTER TABLE row ADD COLUMN half TEXT");
  throw SQLite::Exception("no further");
}
constexpr std::array<Migration, 2> kMigrations = {make_row, add_text};

struct FileTest : testing::Test {
  TemporaryFolder folder;
  const std::string path = folder.file("rows.sqlite");
};

TEST_F(FileTest, SynchronisesEveryCommit) {
  const auto file = open(path);
  EXPECT_EQ(file->execAndGet("PRAGMA journal_mode").getString(), "wal");
  EXPECT_EQ(file->execAndGet("PRAGMA synchronous").getInt(), 2);
}

TEST_F(FileTest, ANewFileBecomesTheLastVersion) {
  const auto file = open(path);
  ASSERT_TRUE(migrate(*file, kMigrations));
  EXPECT_EQ(file->execAndGet("PRAGMA user_version").getInt(), 2);
  EXPECT_EQ(file->exec("INSERT INTO row (number) VALUES (1)"), 1);
}

TEST_F(FileTest, AnOlderFileKeepsItsRows) {
  const auto file = open(path);
  ASSERT_TRUE(migrate(*file, std::span(kMigrations).first(1)));
  file->exec("INSERT INTO row VALUES (7)");
  ASSERT_TRUE(migrate(*file, kMigrations));
  EXPECT_EQ(file->execAndGet("SELECT number || text FROM row").getString(), "7old");
}

TEST_F(FileTest, AMigratedFileIsLeftAsItIs) {
  const auto file = open(path);
  ASSERT_TRUE(migrate(*file, kMigrations));
  ASSERT_TRUE(migrate(*file, kMigrations));
}

TEST_F(FileTest, OfANewerVersionIsRefusedAndNotChanged) {
  const auto file = open(path);
  ASSERT_TRUE(migrate(*file, kMigrations));
  const auto refused = migrate(*file, std::span(kMigrations).first(1));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::version);
  EXPECT_EQ(refused.error().path, path);
  EXPECT_EQ(file->execAndGet("PRAGMA user_version").getInt(), 2);
}

TEST_F(FileTest, AMigrationThatFailsChangesNothing) {
  const auto file = open(path);
  constexpr std::array<Migration, 3> kFailing = {make_row, add_text, fail_half_way};
  EXPECT_FALSE(migrate(*file, kFailing));
  EXPECT_EQ(file->execAndGet("PRAGMA user_version").getInt(), 0);
  EXPECT_EQ(file->execAndGet("SELECT count(*) FROM sqlite_master").getInt(), 0) << "not even those before it";
}

TEST_F(FileTest, IsMigratedOnceByManyThatOpenItAtOnce) {
  std::array<bool, 4> done{};
  {
    std::vector<std::jthread> openers;
    for (bool& one : done)
      openers.emplace_back([&one, this] {
        const auto file = open(path);
        one = migrate(*file, kMigrations).has_value();
      });
  }
  EXPECT_THAT(done, testing::Each(true));
  EXPECT_EQ(open(path)->execAndGet("PRAGMA user_version").getInt(), 2);
}

TEST_F(FileTest, ThatIsReadOnlyCannotBeWritten) {
  ASSERT_TRUE(migrate(*open(path), kMigrations));
  const auto file = open_to_read(path);
  EXPECT_EQ(file->execAndGet("SELECT count(*) FROM row").getInt(), 0);
  try {
    file->exec("INSERT INTO row (number) VALUES (1)");
    FAIL() << "it was written";
  } catch (const SQLite::Exception& exception) {
    EXPECT_EQ(error_of(exception, "cannot write").code, ErrorCode::storage);
  }
}

TEST_F(FileTest, ThatIsNoDatabaseIsCorrupt) {
  std::ofstream(path) << std::string(4096, 'x');
  try {
    open(path);
    FAIL() << "it was opened";
  } catch (const SQLite::Exception& exception) {
    EXPECT_EQ(error_of(exception, "cannot open").code, ErrorCode::corrupt);
  }
}

TEST_F(FileTest, ThatCannotBeMadeIsStorage) {
  try {
    open("/nowhere/at/all.sqlite");
    FAIL() << "it was opened";
  } catch (const SQLite::Exception& exception) {
    const Error error = error_of(exception, "cannot open");
    EXPECT_EQ(error.code, ErrorCode::storage);
    EXPECT_EQ(error.message, "cannot open: unable to open database file");
  }
}

TEST_F(FileTest, WithALostPageIsCorrupt) {
  {
    const auto file = open(path);
    ASSERT_TRUE(migrate(*file, kMigrations));
    file->exec(
        "INSERT INTO row (number) WITH RECURSIVE count(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM count LIMIT 2000)"
        " SELECT i FROM count");
    ASSERT_TRUE(check(*file));
  }
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(2 * 4096) << std::string(4096, '\7');
  const auto sound = check(*open(path));
  ASSERT_FALSE(sound);
  EXPECT_EQ(sound.error().code, ErrorCode::corrupt);
}

/// A file that grows by one row for each commit, through enough commits that the log is copied into the file.
struct Commits {
  explicit Commits(const std::string& path) : file(open(path)) {
    file->exec("PRAGMA wal_autocheckpoint = 8");
    file->exec("CREATE TABLE IF NOT EXISTS row (number INTEGER PRIMARY KEY, text TEXT NOT NULL)");
  }
  void insert(int number) const {
    file->exec("INSERT INTO row VALUES (" + std::to_string(number) + ", hex(zeroblob(700)))");
  }
  const std::unique_ptr<SQLite::Database> file;
};

/// How many rows a program finds that begins on `path`.
int rows_of(const std::string& path) try {
  const auto file = open(path);
  const auto sound = check(*file);
  EXPECT_TRUE(sound) << sound.error().message;
  return file->tableExists("row") ? file->execAndGet("SELECT count(*) FROM row").getInt() : 0;
} catch (const SQLite::Exception& exception) {
  ADD_FAILURE() << exception.what();
  return -1;
}

TEST_F(FileTest, KeepsEveryCommitAfterALossOfPowerAtAnyOperation) {
  const TemporaryFolder after;
  FaultyVfs vfs;
  int committed = 0;
  vfs.before_each([&](std::uint64_t operation) {
    for (const double kept : {0.0, 0.5, 1.0}) {
      const int expected = committed;
      vfs.lose_power(folder.path, after.path, kept, operation);
      const int found = rows_of(after.file("rows.sqlite"));
      EXPECT_TRUE(found == expected || found == expected + 1)
          << found << " of " << expected << " before operation " << operation << ", kept " << kept;
    }
  });
  const Commits commits(path);
  for (int i = 0; i < 20; ++i) {
    commits.insert(i);
    committed = i + 1;
  }
  EXPECT_GT(vfs.operations(), 150U);
}

TEST_F(FileTest, WorksAgainAfterAFailureAtAnyOperation) {
  for (const auto fault : {FaultyVfs::Fault::full, FaultyVfs::Fault::io})
    for (const bool for_ever : {false, true}) {
      bool failed = true;
      for (std::uint64_t nth = 1; failed; ++nth) {
        for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix);
        FaultyVfs vfs;
        const Commits commits(path);
        vfs.fail_at(nth, fault, for_ever);
        std::vector<int> committed;
        for (int i = 0; i < 12; ++i) try {
            commits.insert(i);
            committed.push_back(i);
          } catch (const SQLite::Exception& exception) {
            EXPECT_EQ(error_of(exception, "").code, ErrorCode::storage) << exception.what();
          }
        failed = vfs.has_failed();
        vfs.repair();
        for (const int number : committed)
          EXPECT_EQ(
              commits.file->execAndGet("SELECT count(*) FROM row WHERE number = " + std::to_string(number)).getInt(),
              1);
        EXPECT_NO_THROW(commits.insert(100)) << "operation " << nth;
        EXPECT_TRUE(check(*commits.file));
      }
    }
}

}  // namespace
}  // namespace race::sqlite
