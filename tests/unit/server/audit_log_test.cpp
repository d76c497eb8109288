#include "server/accounts/audit_log.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

AuditEntry entry(int time) { return {0, time, "ada", "10.0.0.7", "POST /api/v1/cores/1/start", "200"}; }

struct AuditLogTest : testing::Test {
  std::unique_ptr<AuditLog> open() {
    const auto failed = [this](const Error& error) {
      const services::MutexLock lock(mutex);
      failures.push_back(error);
    };
    return AuditLog::open(file, failed).value();
  }
  void write(int count) {
    const auto log = open();
    for (int i = 0; i < count; ++i) log->append(entry(i));
  }

  std::vector<Error> all_failures() {
    const services::MutexLock lock(mutex);
    return failures;
  }
  static std::vector<std::int64_t> times(AuditLog& log) {
    std::vector<std::int64_t> times;
    const AuditLog::Page page = log.list(std::nullopt, 100'000).value();
    for (const AuditEntry& entry : page.entries) times.push_back(entry.time);
    return times;
  }

  TemporaryFolder place;
  const std::string file = place.file("audit.sqlite");
  services::Mutex mutex;
  std::vector<Error> failures GUARDED_BY(mutex);
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
  EXPECT_EQ(all_failures().size(), 0U);
  EXPECT_LT(log->list(std::nullopt, 1)->entries.front().number, 4 * static_cast<std::int64_t>(AuditLog::kMostWaiting))
      << "what has no room is left out";
}

using sqlite::FaultyVfs;

TEST_F(AuditLogTest, WhatTheDiskDoesNotTakeIsWrittenInItsOrderWhenItWorksAgain) {
  FaultyVfs disk;
  const auto log = open();
  int time = 0;
  std::size_t told = 0;
  for (const auto fault : {FaultyVfs::Fault::full, FaultyVfs::Fault::io}) {
    disk.fail_at(1, fault, true);
    log->append(entry(time++));
    log->append(entry(time++));
    while (all_failures().size() == told) std::this_thread::yield();
    ++told;
    log->append(entry(time++));
    std::this_thread::sleep_for(AuditLog::kRetry + std::chrono::milliseconds(200));
    EXPECT_EQ(log->waiting(), 3U);
    EXPECT_EQ(all_failures().size(), told) << "it is told once";
    disk.repair();
    while (log->waiting() > 0) std::this_thread::yield();
  }
  EXPECT_THAT(times(*log), testing::ElementsAre(5, 4, 3, 2, 1, 0));
}

TEST_F(AuditLogTest, AsksAFailingDiskOnceASecond) {
  FaultyVfs disk;
  const auto log = open();
  disk.fail_at(1, FaultyVfs::Fault::full, true);
  log->append(entry(0));
  while (all_failures().empty()) std::this_thread::yield();
  const std::uint64_t before = disk.operations();
  std::this_thread::sleep_for(AuditLog::kRetry / 2);
  EXPECT_LT(disk.operations(), before + 100);
}

TEST_F(AuditLogTest, HasNoRoomWhileADiskFailsThatHasNotTakenTooMany) {
  FaultyVfs disk;
  const auto log = open();
  disk.fail_at(1, FaultyVfs::Fault::full, true);
  std::size_t rows = 0;
  for (; log->has_room() && rows < 3 * AuditLog::kMostWaiting; ++rows) {
    log->append(entry(static_cast<int>(rows)));
    if (rows % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));  // some are being written
  }
  EXPECT_EQ(rows, AuditLog::kMostWaiting);
  for (std::size_t i = 0; i < 3 * AuditLog::kMostWaiting; ++i) log->append(entry(static_cast<int>(rows++)));
  EXPECT_EQ(log->waiting(), 2 * AuditLog::kMostWaiting);
  disk.repair();
  while (log->waiting() > 0) std::this_thread::yield();
  const auto written = times(*log);
  ASSERT_EQ(written.size(), 2 * AuditLog::kMostWaiting) << "what has no room is left out";
  EXPECT_EQ(written.back(), 0);
  EXPECT_EQ(written.front(), 2 * AuditLog::kMostWaiting - 1);
}

TEST_F(AuditLogTest, AFailingDiskDoesNotHoldUpTheEndAndWhatIsLostIsTold) {
  FaultyVfs disk;
  auto log = open();
  disk.fail_at(1, FaultyVfs::Fault::full, true);
  log->append(entry(0));
  log->append(entry(1));
  while (all_failures().empty()) std::this_thread::yield();
  log->close();
  EXPECT_EQ(all_failures().back().message, "2 rows of the audit log are lost");
  log.reset();
  EXPECT_EQ(all_failures().size(), 2U);
}

TEST_F(AuditLogTest, TheEndTriesOnceMore) {
  FaultyVfs disk;
  auto log = open();
  disk.fail_at(1, FaultyVfs::Fault::full, true);
  log->append(entry(0));
  while (all_failures().empty()) std::this_thread::yield();
  disk.repair();
  log.reset();
  EXPECT_EQ(open()->list(std::nullopt, 10)->entries.size(), 1U);
}

}  // namespace
}  // namespace race::server
