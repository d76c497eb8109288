// LogFile: a write-ahead log of SQLite as it is on the disk, read frame by frame
// (https://sqlite.org/fileformat2.html#walformat). A header of 32 bytes is followed by frames: 24 bytes and a page
// each. The salts of the header are those of its frames: frames with others are left from an earlier log. Each frame
// holds the checksum of all before it and of itself, so that it can be checked from the checksum that the one before
// holds.
//
// Threads: one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace race::sqlite {

struct LogChecksum {
  std::uint32_t s0 = 0, s1 = 0;
  bool operator==(const LogChecksum&) const = default;
};

/// Of `bytes`, a multiple of eight, read as words of either byte order, after what had the checksum `from`.
LogChecksum log_checksum(std::string_view bytes, bool is_big_endian, LogChecksum from);
/// The four bytes at `at`, the most significant first.
std::uint32_t number_at(std::string_view bytes, std::size_t at);

using LogSalts = std::array<char, 8>;

struct LogLayout {
  std::uint32_t page_size = 0;
  bool is_big_endian = false;  // the words of checksums
};

inline constexpr std::uint32_t kLeastLogPage = 512, kLargestLogPage = 65536;  // each a power of two

struct LogHeader {
  std::string content;  // what the checksum is of
  LogLayout layout;
  LogSalts salts = {};
  LogChecksum stored;
  bool is_sound = false;  // else SQLite takes the log for empty
};

struct LogFrame {
  std::string content;  // what the checksum is of: number of the page, size of the database, page
  LogSalts salts = {};
  LogChecksum stored;

  std::uint32_t page() const { return number_at(content, 0); }
  /// Of the database after the transaction, in pages, in its last frame; else 0.
  std::uint32_t commit_size() const { return number_at(content, 4); }
};

class LogFile {
 public:
  explicit LogFile(const std::string& path);
  /// False: it is too short to have one, or is not there.
  bool read(LogHeader& header);
  /// The frame of this number, from 1. False: the log ends before it does.
  bool read(const LogLayout& layout, std::uint64_t number, LogFrame& frame);
  /// Whether the disk did not give it.
  bool has_failed() const { return stream_.bad(); }

 private:
  bool read(std::uint64_t at, char* bytes, std::size_t size);
  std::ifstream stream_;
  std::uint64_t at_ = 0;
};

}  // namespace race::sqlite
