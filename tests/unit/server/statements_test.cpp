// Statements: prepared once; between two executions they keep nothing.
#include "server/store/statements.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "services/sqlite/file.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

constexpr const char* kInsert = "INSERT INTO t VALUES (?, ?)";
constexpr const char* kSelect = "SELECT text FROM t ORDER BY key";

struct StatementsTest : testing::Test {
  StatementsTest() { file->exec("CREATE TABLE t (key INTEGER PRIMARY KEY, text TEXT)"); }
  void insert(int key, const std::string& text) {
    const auto insert = statements.use(kInsert);
    insert->bind(1, key);
    insert->bind(2, text);
    insert->exec();
  }
  /// Whether no transaction is open that would keep the log.
  bool log_can_be_reset() const {
    SQLite::Statement checkpoint(*other, "PRAGMA wal_checkpoint(TRUNCATE)");
    return checkpoint.executeStep() && checkpoint.getColumn(0).getInt() == 0;
  }

  const TemporaryFolder place;
  const std::unique_ptr<SQLite::Database> file = sqlite::open(place.path / "t.sqlite");
  const std::unique_ptr<SQLite::Database> other = sqlite::open(place.path / "t.sqlite");
  Statements statements{*file};
};

TEST_F(StatementsTest, ArePreparedOnce) {
  const SQLite::Statement* first = &*statements.use(kSelect);
  EXPECT_EQ(&*statements.use(kSelect), first);
  EXPECT_NE(&*statements.use(kInsert), first);
}

TEST_F(StatementsTest, KeepNoParameters) {
  insert(1, "one");
  {
    const auto next = statements.use(kInsert);
    next->bind(1, 2);
    next->exec();
  }
  EXPECT_TRUE(file->execAndGet("SELECT text IS NULL FROM t WHERE key = 2").getInt());
}

TEST_F(StatementsTest, CanBeExecutedAgainAfterAnError) {
  insert(1, "one");
  EXPECT_THROW(insert(1, "again"), SQLite::Exception);
  insert(2, "two");
  EXPECT_EQ(file->execAndGet("SELECT count(*) FROM t").getInt(), 2);
}

TEST_F(StatementsTest, KeepNoTransactionOpen) {
  insert(1, "one");
  insert(2, "two");
  {
    const auto select = statements.use(kSelect);
    ASSERT_TRUE(select->executeStep()) << "and one more row is left";
    insert(3, "three");
    other->exec("PRAGMA busy_timeout = 0");
    EXPECT_FALSE(log_can_be_reset());
  }
  EXPECT_TRUE(log_can_be_reset());
  EXPECT_THROW(insert(1, "again"), SQLite::Exception);
  EXPECT_TRUE(log_can_be_reset());
}

TEST_F(StatementsTest, FollowAFileThatHasBecomeAnother) {
  insert(1, "one");
  other->exec("DROP TABLE t; CREATE TABLE t (key TEXT, text TEXT)");
  insert(2, "two");
  EXPECT_EQ(file->execAndGet("SELECT typeof(key) FROM t").getString(), "text");
}

}  // namespace
}  // namespace race::server
