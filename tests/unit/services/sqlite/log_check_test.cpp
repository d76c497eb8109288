#include "services/sqlite/log_check.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <vector>

#include "services/sqlite/file.h"
#include "tests/unit/services/sqlite/folder.h"

namespace race::sqlite {
namespace {

namespace fs = std::filesystem;

// What a process leaves that is killed: a file, and a log of several transactions.
class LogCheck : public testing::Test {
 protected:
  LogCheck() {
    file_->exec("CREATE TABLE row (text TEXT)");
    for (int i = 0; i < 6; ++i) {
      ends_.push_back(fs::file_size(folder_.file("live-wal")));
      file_->exec("INSERT INTO row VALUES (hex(zeroblob(3000)))");
    }
    ends_.push_back(fs::file_size(folder_.file("live-wal")));
    fs::copy(folder_.file("live"), path_);
    fs::copy(folder_.file("live-wal"), log_);
  }

  /// Flips a bit of the log.
  void flip(std::uintmax_t byte) const {
    std::fstream file(log_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(byte));
    const int old = file.get();
    file.seekp(static_cast<std::streamoff>(byte));
    file.put(static_cast<char>(old ^ (1 << (byte % 8))));
  }

  ErrorCode code() const { return check_log(path_).error().code; }

  const Folder folder_{"log_check"};
  const std::unique_ptr<SQLite::Database> file_ = open(folder_.file("live"));
  const std::string path_ = folder_.file("left"), log_ = path_ + "-wal";
  std::vector<std::uintmax_t> ends_;  // of each transaction in the log
};

TEST_F(LogCheck, AcceptsALogThatIsWhole) {
  EXPECT_TRUE(check_log(path_));
  EXPECT_TRUE(check_log(folder_.file("none")));
}

TEST_F(LogCheck, AcceptsATornLastTransaction) {
  const std::uintmax_t last = ends_[ends_.size() - 2];
  for (std::uintmax_t byte = last; byte < ends_.back(); byte += 997) {
    flip(byte);
    EXPECT_TRUE(check_log(path_)) << byte;
    flip(byte);
  }
  fs::resize_file(log_, last + 1000);
  EXPECT_TRUE(check_log(path_));
}

TEST_F(LogCheck, NamesAFlippedBitBeforeWholeTransactions) {
  for (std::uintmax_t byte = 0; byte < ends_[ends_.size() - 3]; byte += byte < 60 ? 1 : 997) {
    flip(byte);
    ASSERT_FALSE(check_log(path_)) << byte;
    EXPECT_EQ(code(), ErrorCode::corrupt);
    flip(byte);
  }
}

TEST_F(LogCheck, AcceptsWhatIsLeftOfAnEarlierUseOfTheLog) {
  file_->exec("PRAGMA wal_checkpoint(RESTART)");
  file_->exec("INSERT INTO row VALUES ('new')");
  fs::copy(folder_.file("live-wal"), log_, fs::copy_options::overwrite_existing);
  EXPECT_EQ(fs::file_size(log_), ends_.back());
  EXPECT_TRUE(check_log(path_));
}

}  // namespace
}  // namespace race::sqlite
