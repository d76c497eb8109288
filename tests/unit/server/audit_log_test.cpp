#include "server/accounts/audit_log.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

AuditEntry entry(int time) { return {0, time, "ada", "10.0.0.7", "POST /api/v1/cores/1/start", "200"}; }

struct AuditLogTest : testing::Test {
  std::unique_ptr<AuditLog> open() {
    return AuditLog::open(file, [this](const Error& error) { failures.push_back(error); }).value();
  }
  void write(int count) {
    const auto log = open();
    for (int i = 0; i < count; ++i) log->append(entry(i));
  }

  TemporaryFolder place;
  const std::string file = place.file("audit.sqlite");
  std::vector<Error> failures;
};

TEST_F(AuditLogTest, KeepsWhatWasDoneInItsOrderTheLastFirst) {
  write(3);
  auto entries = open()->list(std::nullopt, 10)->entries;
  ASSERT_EQ(entries.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    AuditEntry expected = entry(2 - i);
    expected.number = 3 - i;
    EXPECT_EQ(entries[static_cast<std::size_t>(i)], expected);
  }
}

TEST_F(AuditLogTest, IsReadInPages) {
  write(5);
  const auto log = open();
  const auto first = log->list(std::nullopt, 2).value();
  EXPECT_EQ(first.entries.back().number, 4);
  EXPECT_EQ(first.next, 4);
  const auto rest = log->list(first.next, 3).value();
  EXPECT_EQ(rest.entries.front().number, 3);
  EXPECT_EQ(rest.entries.back().number, 1);
  EXPECT_FALSE(rest.next);
}

TEST_F(AuditLogTest, CutsALongActionAtAWholeCharacter) {
  {
    const auto log = open();
    AuditEntry long_one = entry(1);
    long_one.action = std::string(AuditLog::kLongest - 1, 'x') + "ää";
    log->append(long_one);
  }
  EXPECT_EQ(open()->list(std::nullopt, 1)->entries.front().action, std::string(AuditLog::kLongest - 1, 'x'));
}

TEST_F(AuditLogTest, NamesARowThatWasChangedOrTakenOut) {
  write(4);
  const TemporaryFolder saved;
  std::filesystem::copy_file(file, saved.file("audit"));
  for (const char* damage : {"UPDATE audit SET account = 'eve' WHERE number = 3", "DELETE FROM audit WHERE number = 2",
                             "UPDATE audit SET number = 9 WHERE number = 4"}) {
    std::filesystem::copy_file(saved.file("audit"), file, std::filesystem::copy_options::overwrite_existing);
    SQLite::Database(file, SQLite::OPEN_READWRITE).exec(damage);
    const auto opened = AuditLog::open(file, {});
    ASSERT_FALSE(opened) << damage;
    EXPECT_EQ(opened.error().code, ErrorCode::corrupt) << damage;
  }
}

TEST_F(AuditLogTest, TheOldestGoAndTheRestIsStillAChain) {
  write(3);
  {
    SQLite::Database database(file, SQLite::OPEN_READWRITE);
    database.exec("DELETE FROM audit WHERE number <= 2");  // as remove_oldest() does
  }
  write(1);
  EXPECT_EQ(open()->list(std::nullopt, 10)->entries.size(), 2U);
}

TEST_F(AuditLogTest, HasRoomUntilTooManyWaitForTheDisk) {
  const auto log = open();
  SQLite::Database other(file, SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");  // the disk is slow
  std::size_t waiting = 0;
  for (; log->has_room() && waiting < 3 * AuditLog::kMostWaiting; ++waiting) log->append(entry(1));
  EXPECT_GE(waiting, AuditLog::kMostWaiting);
  EXPECT_FALSE(log->has_room());
  for (std::size_t i = 0; i < 3 * AuditLog::kMostWaiting; ++i) log->append(entry(1));  // what nobody may refuse
  other.exec("COMMIT");
  while (!log->has_room()) std::this_thread::yield();
  EXPECT_EQ(failures.size(), 0U);
  EXPECT_LT(log->list(std::nullopt, 1)->entries.front().number, 4 * static_cast<std::int64_t>(AuditLog::kMostWaiting))
      << "what has no room is left out";
}

}  // namespace
}  // namespace race::server
