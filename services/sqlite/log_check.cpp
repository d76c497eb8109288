#include "services/sqlite/log_check.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace race::sqlite {
namespace {

// As https://sqlite.org/fileformat2.html, section 4, has them.
constexpr std::size_t kHeaderBytes = 32, kFrameHeaderBytes = 24;
constexpr std::uint32_t kMagic = 0x377f0682;  // the last bit: words of checksums are big-endian
constexpr std::uint32_t kLeastPage = 512, kMostPage = 65536;

using Bytes = std::vector<unsigned char>;

std::uint32_t big_endian(const unsigned char* at) {
  return std::uint32_t{at[0]} << 24U | std::uint32_t{at[1]} << 16U | std::uint32_t{at[2]} << 8U | std::uint32_t{at[3]};
}

std::uint32_t little_endian(const unsigned char* at) {
  return std::uint32_t{at[3]} << 24U | std::uint32_t{at[2]} << 16U | std::uint32_t{at[1]} << 8U | std::uint32_t{at[0]};
}

struct Checksum {
  std::uint32_t first = 0, second = 0;
  bool operator==(const Checksum&) const = default;

  static Checksum stored(const unsigned char* at) { return {big_endian(at), big_endian(at + 4)}; }
  void add(const unsigned char* at, std::size_t bytes, bool is_big_endian) {
    const auto word = is_big_endian ? big_endian : little_endian;
    for (std::size_t i = 0; i < bytes; i += 8) {
      first += word(at + i) + second;
      second += word(at + i + 4) + first;
    }
  }
};

struct Log {
  const unsigned char* header;
  bool is_big_endian;
  std::size_t frame_bytes;

  bool is_salted_as(const unsigned char* frame) const {
    return std::string_view(reinterpret_cast<const char*>(header) + 16, 8) ==
           std::string_view(reinterpret_cast<const char*>(frame) + 8, 8);
  }
  /// What the frame's checksum should be, after one with the checksum `before`.
  Checksum checksum(const unsigned char* frame, Checksum before) const {
    before.add(frame, 8, is_big_endian);
    before.add(frame + kFrameHeaderBytes, frame_bytes - kFrameHeaderBytes, is_big_endian);
    return before;
  }
};

bool is_header(const Bytes& bytes) {
  const std::uint32_t magic = big_endian(bytes.data()), page = big_endian(bytes.data() + 8);
  Checksum sum;
  sum.add(bytes.data(), kHeaderBytes - 8, (magic & 1U) != 0);
  return (magic & ~1U) == kMagic && page >= kLeastPage && page <= kMostPage &&
         sum == Checksum::stored(bytes.data() + kHeaderBytes - 8);
}

/// Behind a frame that does not fit, frames that fit each other go on after the end of a transaction. (What a failed
/// transaction left behind the last commit fits no further than its own end.)
bool has_commits_behind_damage(const Bytes& bytes) {
  const Log log{bytes.data(), (bytes[3] & 1U) != 0, kFrameHeaderBytes + big_endian(bytes.data() + 8)};
  Checksum before = Checksum::stored(bytes.data() + kHeaderBytes - 8);
  bool is_damaged = false, is_committed = false;
  for (std::size_t at = kHeaderBytes; at + log.frame_bytes <= bytes.size(); at += log.frame_bytes) {
    const unsigned char* frame = bytes.data() + at;
    const Checksum stored = Checksum::stored(frame + kFrameHeaderBytes - 8);
    const bool fits = log.is_salted_as(frame) && log.checksum(frame, before) == stored;
    if (fits && is_damaged && is_committed) return true;
    if (!fits) is_damaged = true;
    is_committed = big_endian(frame + 4) != 0 && (fits || log.is_salted_as(frame));
    before = stored;
  }
  return false;
}

}  // namespace

Expected<void> check_log(const std::string& path) {
  const std::string name = path + "-wal";
  std::error_code none;
  if (std::filesystem::file_size(name, none) <= kHeaderBytes || none) return {};
  std::ifstream file(name, std::ios::binary);
  const Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || bytes.size() <= kHeaderBytes) return unexpected(ErrorCode::storage, "cannot read the log", name);
  if (!is_header(bytes)) return unexpected(ErrorCode::corrupt, "the header of the log is damaged", name);
  if (has_commits_behind_damage(bytes)) return unexpected(ErrorCode::corrupt, "the log is damaged", name);
  return {};
}

}  // namespace race::sqlite
