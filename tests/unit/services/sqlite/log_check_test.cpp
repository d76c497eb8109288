#include "services/sqlite/log_check.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>

#include "services/sqlite/file.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/temporary_folder.h"

namespace race::sqlite {
namespace {

namespace fs = std::filesystem;

constexpr int kCommits = 24, kFlips = 300, kLastTransaction = 1;

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

void flip(const fs::path& path, std::size_t bit) {
  std::fstream stream(path, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(bit / 8));
  const int byte = stream.get();
  stream.seekp(static_cast<std::streamoff>(bit / 8));
  stream.put(static_cast<char>(byte ^ (1 << bit % 8)));
}

struct LogCheckTest : testing::Test {
  TemporaryFolder disk, after;
  const std::string path = disk.file("rows.sqlite"), copy = after.file("rows.sqlite");

  /// A row of several pages now and then, so that transactions have one frame and more.
  static void insert(SQLite::Database& file, int number) {
    const int size = number % 3 == 0 ? 6000 : 300;
    file.exec("INSERT INTO row VALUES (" + std::to_string(number) + ", randomblob(" + std::to_string(size) + "))");
  }
  std::unique_ptr<SQLite::Database> open_table() const {
    auto file = open(path);
    file->exec("CREATE TABLE IF NOT EXISTS row (number INTEGER PRIMARY KEY, text BLOB NOT NULL)");
    return file;
  }
  /// As a crash of the process leaves them: what an open file is now.
  void copy_files() const {
    fs::remove_all(after.path);
    fs::create_directories(after.path);
    fs::copy_file(path, copy);
    if (fs::exists(path + "-wal")) fs::copy_file(path + "-wal", copy + "-wal");
  }
  /// The rows that SQLite finds in the copy; none: it says that the file is damaged itself.
  std::optional<int> rows_of_copy() const try {
    const auto file = open(copy);
    if (!check(*file)) return {};
    return file->execAndGet("SELECT count(*) FROM row").getInt();
  } catch (const SQLite::Exception&) {
    return {};
  }
  void expect_sound(const std::string& what) const {
    const auto sound = check_log(copy);
    EXPECT_TRUE(sound) << what << ": " << sound.error().message;
  }

  /// Flips bits of the log of `rows` rows, one after the other; each is named, or concerns the last transaction only.
  void flip_bits(const std::vector<std::size_t>& bits, int rows) const {
    copy_files();
    const std::string database = content_of(copy), log = content_of(copy + "-wal");
    int named = 0;
    for (const std::size_t bit : bits) {
      flip(copy + "-wal", bit);
      if (const auto sound = check_log(copy); !sound) {
        EXPECT_EQ(sound.error().code, ErrorCode::corrupt);
        EXPECT_EQ(sound.error().path, copy + "-wal");
        ++named;
        flip(copy + "-wal", bit);
        continue;
      }
      const auto found = rows_of_copy();
      EXPECT_GE(found.value_or(rows), rows - kLastTransaction) << "bit " << bit % 8 << " of byte " << bit / 8;
      fs::remove(copy + "-shm");
      write(copy, database);
      write(copy + "-wal", log);
    }
    std::cout << named << " of " << bits.size() << " named\n";
    EXPECT_GT(named, 0);
  }
};

TEST_F(LogCheckTest, OfNoLogIsSound) {
  EXPECT_TRUE(check_log(path));
  open_table().reset();
  EXPECT_TRUE(check_log(path));
  write(path + "-wal", "");
  EXPECT_TRUE(check_log(path));
}

TEST_F(LogCheckTest, OfManyCommitsCheckpointsAndRestartsIsSound) {
  for (int restart = 0; restart < 3; ++restart) {
    const auto file = open_table();
    for (int number = 0; number < 60; ++number) {
      insert(*file, 100 * restart + number);
      if (number % 25 == 20) file->exec("PRAGMA wal_checkpoint(FULL)");  // the next commit begins the log again
      if (number == 50) file->exec("PRAGMA wal_checkpoint(TRUNCATE)");
      copy_files();
      expect_sound("row " + std::to_string(number));
      EXPECT_EQ(rows_of_copy(), 60 * restart + number + 1);
    }
  }
}

TEST_F(LogCheckTest, ALossOfPowerAtAnyOperationIsNoDamage) {
  constexpr std::uint64_t kSeed = 20261122;
  std::cout << "seed " << kSeed << '\n';
  FaultyVfs vfs;
  int losses = 0;
  vfs.before_each([&](std::uint64_t operation) {
    for (const double kept : {0.0, 0.5, 0.5, 0.9, 1.0}) {
      vfs.lose_power(disk.path, after.path, kept, kSeed + 10 * operation + static_cast<std::uint64_t>(++losses));
      expect_sound("operation " + std::to_string(operation) + ", kept " + std::to_string(kept));
    }
  });
  for (int restart = 0; restart < 2; ++restart) {
    const auto file = open_table();
    file->exec("PRAGMA cache_size = 4");  // long transactions write to the log before they end
    for (int number = 0; number < 12; ++number) {
      SQLite::Transaction transaction(*file);
      for (int row = 0; row < 1 + 7 * (number % 2); ++row) insert(*file, 1000 * restart + 10 * number + row);
      if (number % 4 != 3) transaction.commit();
      if (number == 6) file->exec("PRAGMA wal_checkpoint(FULL)");
    }
  }
  EXPECT_GT(losses, 500);
}

// After a loss of power the server goes on with the log that was left, and power is lost again.
TEST_F(LogCheckTest, RepeatedLossesOfPowerAreNoDamage) {
  constexpr std::uint64_t kSeed = 7;
  std::cout << "seed " << kSeed << '\n';
  std::mt19937_64 random(kSeed);
  int losses = 0;
  for (int round = 0; round < 60; ++round) {
    const std::uint64_t last = 1 + random() % 60 + 10;
    const double kept = std::array{0.3, 0.7, 0.95}[random() % 3];
    {
      FaultyVfs vfs;
      const std::uint64_t begin = vfs.operations();
      vfs.before_each([&](std::uint64_t operation) {
        if (operation == begin + last) vfs.lose_power(disk.path, after.path, kept, random());
      });
      const auto file = open_table();
      for (int number = 0; number < 6; ++number) {
        SQLite::Transaction transaction(*file);
        for (std::uint64_t row = random() % 8 + 1; row > 0; --row)
          file->exec("INSERT INTO row (text) VALUES (randomblob(" + std::to_string(random() % 6000) + "))");
        transaction.commit();
      }
      if (vfs.operations() < begin + last) continue;
    }
    expect_sound("round " + std::to_string(round));
    ++losses;
    fs::remove_all(disk.path);
    fs::copy(after.path, disk.path);
  }
  EXPECT_GT(losses, 20);
}

TEST_F(LogCheckTest, AFullDiskIsNoDamage) {
  for (const bool for_ever : {false, true})
    for (std::uint64_t nth = 1; nth < 60; ++nth) {
      fs::remove_all(disk.path);
      fs::create_directories(disk.path);
      FaultyVfs vfs;
      const auto file = open_table();
      for (int number = 0; number < 5; ++number) insert(*file, number);
      file->exec("PRAGMA wal_checkpoint(FULL)");
      vfs.fail_at(nth, FaultyVfs::Fault::full, for_ever);
      for (int number = 5; number < 15; ++number) try {
          insert(*file, number);
        } catch (const SQLite::Exception&) {
        }
      copy_files();
      expect_sound("full at " + std::to_string(nth));
      vfs.repair();
      insert(*file, 20);
      copy_files();
      expect_sound("goes on after " + std::to_string(nth));
    }
}

TEST_F(LogCheckTest, NamesAFlippedBitUnlessOnlyTheLastTransactionIsConcerned) {
  constexpr std::uint64_t kSeed = 20261122;
  std::cout << "seed " << kSeed << '\n';
  std::mt19937_64 random(kSeed);
  const auto file = open_table();
  for (int number = 1; number <= kCommits; ++number) insert(*file, number);
  const std::size_t size = fs::file_size(path + "-wal");
  std::vector<std::size_t> bits;
  for (std::size_t bit = 0; bit < std::size_t{32 * 8}; ++bit) bits.push_back(bit);  // the header
  for (std::size_t frame = 32; frame < size; frame += 24 + 4096) {
    for (std::size_t bit = 0; bit < std::size_t{24 * 8}; bit += 1 + random() % 8) bits.push_back(frame * 8 + bit);
    for (int page = 0; page < 6; ++page) bits.push_back((frame + 24) * 8 + random() % (std::size_t{4096} * 8));
  }
  flip_bits(bits, kCommits);
}

TEST_F(LogCheckTest, NamesAFlippedBitAfterTheLogBeganAgain) {
  constexpr std::uint64_t kSeed = 4;
  std::cout << "seed " << kSeed << '\n';
  std::mt19937_64 random(kSeed);
  const auto file = open_table();
  for (int number = 1; number <= kCommits; ++number) insert(*file, number);
  file->exec("PRAGMA wal_checkpoint(FULL)");
  for (int number = kCommits + 1; number <= kCommits + 6; ++number) insert(*file, number);
  const std::size_t size = fs::file_size(path + "-wal");
  std::vector<std::size_t> bits;
  for (int flip = 0; flip < kFlips; ++flip) bits.push_back(random() % (size * 8));
  for (std::size_t bit = 0; bit < std::size_t{32 * 8}; ++bit) bits.push_back(bit);
  flip_bits(bits, kCommits + 6);
}

TEST_F(LogCheckTest, ADamagedHeaderOfALogThatTheDatabaseHasIsHarmless) {
  const auto file = open_table();
  for (int number = 1; number <= kCommits; ++number) insert(*file, number);
  file->exec("PRAGMA wal_checkpoint(FULL)");
  copy_files();
  std::string log = content_of(copy + "-wal");
  log[20] = static_cast<char>(log[20] ^ 1);
  write(copy + "-wal", log);
  expect_sound("damaged header");
  EXPECT_EQ(rows_of_copy(), kCommits);
}

TEST_F(LogCheckTest, NamesTheDamagedFrame) {
  const auto file = open_table();
  for (int number = 1; number <= kCommits; ++number) insert(*file, number);
  copy_files();
  std::string log = content_of(copy + "-wal");
  log[32 + 4 * (24 + 4096) + 100] ^= 1;
  write(copy + "-wal", log);
  EXPECT_EQ(check_log(copy).error(),
            (Error{ErrorCode::corrupt, "frame 5 of the log is damaged; restore a backup", copy + "-wal"}));
}

}  // namespace
}  // namespace race::sqlite
