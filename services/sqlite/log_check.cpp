#include "services/sqlite/log_check.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include "services/sqlite/log_file.h"

namespace race::sqlite {
namespace {

constexpr int kRepeats = 3;

/// What the checksum of a frame goes on from: that of the one before (or of the header), as stored and of its content.
struct Link {
  LogChecksum stored, computed;
  bool is_broken() const { return stored != computed; }
};

/// Corrects the one bit of `content` because of which its checksum is not the stored one. False: there is none such.
// The checksum is linear: a word that is larger by d makes it larger by d times a weight of the word's place.
bool correct_bit(std::string& content, bool is_big_endian, const Link& link) {
  const LogChecksum missing = {link.stored.s0 - link.computed.s0, link.stored.s1 - link.computed.s1};
  std::array<LogChecksum, 2> weights = {{{0, 1}, {1, 1}}};  // of the last word and the one before it
  for (std::size_t word = content.size() / 4; word-- > 0;) {
    LogChecksum& weight = weights[1 - word % 2];
    for (std::size_t bit = 0; bit < 32; ++bit) {
      char& byte = content[4 * word + (is_big_endian ? 3 - bit / 8 : bit / 8)];
      const char mask = static_cast<char>(1U << bit % 8);
      const std::uint32_t more = (byte & mask) != 0 ? 0 - (1U << bit) : 1U << bit;
      if (LogChecksum{more * weight.s0, more * weight.s1} != missing) continue;
      byte = static_cast<char>(byte ^ mask);
      return true;
    }
    weight = {weight.s0 + weight.s1, weight.s0 + 2 * weight.s1};
  }
  return false;
}

/// The frames of a log in their order, each checked against the one before.
class Chain {
 public:
  Chain(LogFile& log, const LogLayout& layout, const LogSalts& salts, const Link& header)
      : log_(log), layout_(layout), salts_(salts), link_(header) {}

  bool read_next() {
    std::swap(frame_, last_);
    before_ = link_;
    if (!log_.read(layout_, ++number_, frame_)) return false;
    const LogChecksum computed = log_checksum(frame_.content, layout_.is_big_endian, before_.stored);
    fits_stored_ = computed == frame_.stored;
    fits_computed_ = !fits_stored_ && before_.is_broken() &&
                     log_checksum(frame_.content, layout_.is_big_endian, before_.computed) == frame_.stored;
    link_ = {frame_.stored, fits_computed_ ? frame_.stored : computed};
    return true;
  }

  const LogFrame& frame() const { return frame_; }
  std::uint64_t number() const { return number_; }
  /// As SQLite sees it.
  bool is_valid() const { return is_ours() && fits_stored_; }
  /// Whether it was written after the frame before it, of which the content or the checksum may be damaged since.
  bool follows() const { return is_ours() && (fits_stored_ || fits_computed_); }
  /// Whether the frame before ended a transaction. Requires that this one follows.
  bool begins_transaction() const {
    if (number_ == 1) return false;
    if (!before_.is_broken() || fits_computed_) return last_.commit_size() != 0;
    std::string content = last_.content;  // its checksum is the one that this frame goes on from
    return correct_bit(content, layout_.is_big_endian, before_) && number_at(content, 4) != 0;
  }

 private:
  bool is_ours() const { return frame_.salts == salts_ && frame_.page() != 0; }

  LogFile& log_;
  const LogLayout layout_;
  const LogSalts salts_;
  LogFrame last_, frame_;
  Link before_, link_;
  std::uint64_t number_ = 0;
  bool fits_stored_ = false, fits_computed_ = false;
};

/// The first frame that SQLite does not accept, if a transaction after its own was begun.
std::optional<std::uint64_t> find_damaged_frame(Chain chain) {
  std::optional<std::uint64_t> invalid;
  while (chain.read_next()) {
    if (invalid && chain.follows() && chain.begins_transaction()) return invalid;
    if (!invalid && !chain.is_valid()) invalid = chain.number();
  }
  return {};
}

bool has_two_transactions(Chain chain) {
  while (chain.read_next() && chain.follows())
    if (chain.begins_transaction()) return true;
  return false;
}

/// Whether the database has the pages as the transactions of the log left them.
bool is_in_database(Chain chain, const LogLayout& layout, LogFile& log, const std::string& database_path) {
  std::map<std::uint32_t, std::uint64_t> committed, begun;  // the last frame of each page
  std::uint32_t size = 0;
  while (chain.read_next() && chain.follows()) {
    begun[chain.frame().page()] = chain.number();
    if (chain.frame().commit_size() == 0) continue;
    size = chain.frame().commit_size();
    for (const auto& [page, number] : begun) committed[page] = number;
    begun.clear();
  }
  std::ifstream database(database_path, std::ios::binary);
  std::string stored(layout.page_size, '\0');
  LogFrame frame;
  for (const auto& [page, number] : committed) {
    if (page > size) break;  // removed since
    database.seekg(static_cast<std::streamoff>(std::uint64_t{page - 1} * layout.page_size));
    if (!database.read(stored.data(), static_cast<std::streamsize>(stored.size()))) return false;
    if (!log.read(layout, number, frame) || frame.content.compare(8, stored.size(), stored) != 0) return false;
  }
  return true;
}

/// Whether SQLite would drop transactions because of a damaged header: how the log was written is found by trying.
bool is_header_missed(LogFile& log, const LogHeader& header, const std::string& database_path) {
  for (std::uint32_t page_size = kLeastLogPage; page_size <= kLargestLogPage; page_size *= 2)
    for (const bool is_big_endian : {false, true}) {
      const LogLayout layout = {page_size, is_big_endian};
      LogFrame first;
      if (!log.read(layout, 1, first)) continue;
      const Link link = {header.stored, log_checksum(header.content, is_big_endian, {})};
      const Chain chain(log, layout, first.salts, link);
      if (has_two_transactions(chain)) return !is_in_database(chain, layout, log, database_path);
    }
  return false;
}

Expected<void> check_once(const std::string& path, const std::string& database_path) {
  LogFile log(path);
  LogHeader header;
  std::string damaged;
  if (!log.read(header)) {
    // no log: nothing was committed to it
  } else if (!header.is_sound) {
    if (is_header_missed(log, header, database_path)) damaged = "the header";
  } else if (const auto frame = find_damaged_frame(
                 Chain(log, header.layout, header.salts, {.stored = header.stored, .computed = header.stored}))) {
    damaged = "frame " + std::to_string(*frame);
  }
  if (log.has_failed()) return unexpected(ErrorCode::storage, "the disk fails", path);
  if (damaged.empty()) return {};
  return unexpected(ErrorCode::corrupt, damaged + " of the log is damaged; restore a backup", path);
}

}  // namespace

// A log that another process writes meanwhile may look damaged: damage is there again.
Expected<void> check_log(const std::string& database_path) {
  std::error_code ignored;  // then the path as it is
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(database_path, ignored);
  const std::string database = ignored ? database_path : resolved.string(), log = database + "-wal";
  auto sound = check_once(log, database);
  for (int again = 0; again < kRepeats && !sound; ++again) {
    auto now = check_once(log, database);
    if (now || now.error() == sound.error()) return now;
    sound = std::move(now);
  }
  return sound;
}

}  // namespace race::sqlite
