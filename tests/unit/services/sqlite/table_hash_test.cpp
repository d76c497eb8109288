#include "services/sqlite/table_hash.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <gtest/gtest.h>

#include "services/sqlite/file.h"

namespace race::sqlite {
namespace {

struct TableHashTest : testing::Test {
  TableHashTest() {
    make_table_hashes(*file);
    file->exec("CREATE TABLE row (number INTEGER PRIMARY KEY)");
    keep_schema(*file);
  }
  const std::unique_ptr<SQLite::Database> file = open(":memory:");
  const Digest a = sha256("a"), b = sha256("b"), c = sha256("c");
};

TEST_F(TableHashTest, DoesNotDependOnTheOrderOfChanges) {
  TableHash one, other;
  for (const Digest& row : {a, b, c}) one.insert(row);
  one.remove(b);
  for (const Digest& row : {c, a}) other.insert(row);
  EXPECT_EQ(one, other);
}

TEST_F(TableHashTest, TellsALostAndAnOtherRow) {
  TableHash all, lost, other;
  for (const Digest& row : {a, b}) all.insert(row);
  lost.insert(a);
  for (const Digest& row : {a, c}) other.insert(row);
  EXPECT_NE(all, lost);
  EXPECT_NE(all, other);
}

TEST_F(TableHashTest, IsKeptForEachTable) {
  EXPECT_EQ(TableHash::read(*file, "row").value(), TableHash());
  TableHash hash;
  hash.insert(a);
  hash.write(*file, "row");
  EXPECT_EQ(TableHash::read(*file, "row").value(), hash);
  EXPECT_EQ(TableHash::read(*file, "other").value(), TableHash());
}

TEST_F(TableHashTest, ThatIsDamagedIsCorrupt) {
  TableHash hash;
  hash.insert(a);
  for (const char* damage : {"rows = 2", "sum = zeroblob(32)", "sum = x'00'", "digest = zeroblob(32)"}) {
    hash.write(*file, "row");
    file->exec(std::string("UPDATE table_hash SET ") + damage + " WHERE name = 'row'");
    const auto read = TableHash::read(*file, "row");
    ASSERT_FALSE(read) << damage;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  }
}

TEST_F(TableHashTest, OfTheSchemaTellsAChangedTable) {
  ASSERT_TRUE(check_schema(*file));
  file->exec("ALTER TABLE row ADD COLUMN text TEXT");
  const auto changed = check_schema(*file);
  ASSERT_FALSE(changed);
  EXPECT_EQ(changed.error().code, ErrorCode::corrupt);
  keep_schema(*file);
  EXPECT_TRUE(check_schema(*file));
}

}  // namespace
}  // namespace race::sqlite
