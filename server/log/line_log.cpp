#include "server/log/line_log.h"

#include <limits.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>

#include "core/language/primitives/utf8.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

namespace utf8 = language::utf8;

constexpr std::array<std::string_view, 4> kLevels = {"error", "warning", "info", "debug"};
constexpr std::size_t kMaxComponent = 80;
static_assert(kMaxLogLine <= PIPE_BUF);
constexpr std::string_view kCut = "...";

std::string code(const char* format, unsigned value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string foreign_byte(unsigned char byte) { return code("\\x%02x", byte); }

std::string escaped(char32_t c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  if (c == '\\') return "\\\\";
  if (is_control(c)) return code("\\u%04x", static_cast<unsigned>(c));
  std::string text;
  utf8::append(c, text);
  return text;
}

// The next character of `text`, escaped; `at` moves behind it. Of a text that is no UTF-8, the next byte.
std::string next_piece(std::string_view text, bool is_utf8, std::size_t& at) {
  if (is_utf8) return escaped(utf8::next(text, at));
  const auto byte = static_cast<unsigned char>(text[at++]);
  return byte < 0x80 ? escaped(byte) : foreign_byte(byte);
}

// Adds `text`, escaped, to `line`, which gets no longer than `most`.
void append_escaped(std::string& line, std::string_view text, std::size_t most) {
  const bool is_utf8 = utf8::valid(text);
  std::size_t cut = line.size();  // where there is still place for kCut
  for (std::size_t at = 0; at < text.size();) {
    const std::string piece = next_piece(text, is_utf8, at);
    if (line.size() + piece.size() > most) {
      line.resize(cut);
      line += kCut;
      return;
    }
    line += piece;
    if (line.size() + kCut.size() <= most) cut = line.size();
  }
}

std::string time_text(std::int64_t now_ms) {
  const std::time_t seconds = now_ms / 1000;
  std::tm utc = {};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> day{};
  std::strftime(day.data(), day.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  return day.data() + ("." + std::to_string(1000 + now_ms % 1000).substr(1)) + "Z";
}

}  // namespace

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c <= 0x9f) || (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
}

std::string_view name(LogLevel level) { return kLevels[static_cast<std::size_t>(level)]; }

std::span<const std::string_view> log_level_names() { return kLevels; }

std::optional<LogLevel> log_level_of(std::string_view name) {
  const auto found = std::ranges::find(kLevels, name);
  if (found == kLevels.end()) return std::nullopt;
  return static_cast<LogLevel>(found - kLevels.begin());
}

std::string as_utf8(std::string_view text) {
  if (utf8::valid(text)) return std::string(text);
  std::string valid;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
      valid += c;
    else
      valid += foreign_byte(byte);
  }
  return valid;
}

std::string log_line(std::int64_t now_ms, LogLevel level, std::string_view component, std::string_view text) {
  std::string line = time_text(now_ms) + ' ' + std::string(name(level)) + ' ';
  append_escaped(line, component, line.size() + kMaxComponent);
  line += ": ";
  append_escaped(line, text, kMaxLogLine - 1);
  return line + '\n';
}

void LineLog::write(LogLevel level, std::string_view component, std::string_view text) {
  if (level > most_) return;
  const std::int64_t now = now_ms();
  const services::MutexLock lock(mutex_);
  if (!has_place()) {
    ++dropped_;
    return;
  }
  if (dropped_ > 0) {
    put(log_line(now, LogLevel::warning, "log", std::to_string(dropped_) + " lines had no place and are not here"));
    dropped_ = 0;
    if (!has_place()) {
      ++dropped_;
      return;
    }
  }
  put(log_line(now, level, component, text));
}

// Of a pipe: for PIPE_BUF bytes, which are more than a line.
bool LineLog::has_place() const {
  pollfd asked{file_, POLLOUT, 0};
  return ::poll(&asked, 1, 0) == 1 && (asked.revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
}

// A log that cannot be written is no reason to stop what the server does.
void LineLog::put(const std::string& line) const {
  [[maybe_unused]] const ssize_t written = ::write(file_, line.data(), line.size());
}

}  // namespace race::server
