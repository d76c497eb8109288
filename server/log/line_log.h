// LineLog: the log for the people who run the server: a line for each event, on stderr.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "services/mutex.h"

namespace race::server {

/// How much an event matters, from what matters most. Of the log's lines; each level has those before it, too.
enum class LogLevel : std::uint8_t {
  error,    // something failed or is damaged; somebody should look
  warning,  // the server goes on, but not as it should: a run is interrupted, nothing is started at boot
  info,     // what begins and ends: the server, runs, services
  debug,    // what tasks print
};

/// "error", "warning", "info", "debug".
std::string_view name(LogLevel level);
/// All of them, in this order.
std::span<const std::string_view> log_level_names();
std::optional<LogLevel> log_level_of(std::string_view name);

/// The most bytes of a line, with its end: a pipe takes so many at once, so that lines of processes do not mix.
inline constexpr std::size_t kMaxLogLine = 2048;

/// What could end a line or change what a terminal shows: controls (C0, DEL, C1), the separators of lines and
/// paragraphs, and what turns the direction of writing.
bool is_control(char32_t c);

/// `text`, or, if it is no UTF-8 (an exception's text, a path), its bytes: ASCII as it is, others as `\xff`.
std::string as_utf8(std::string_view text);

/// `2026-11-23T07:51:56.123Z info server: text`, with an end of line and at most kMaxLogLine bytes; what is longer ends
/// with `...`. Characters that could end a line or change what a terminal shows are escaped in `component` and `text`
/// (`\n`, `\u001b`; a backslash is `\\`; bytes that are no UTF-8 are `\xff`), so that a text from outside makes no
/// line.
std::string log_line(std::int64_t now_ms, LogLevel level, std::string_view component, std::string_view text);

class LineLog {
 public:
  /// Writes lines of `most` and of what matters more to `file`, a descriptor, which stays open. A line that a reader
  /// leaves no place for is dropped, and the next one says how many were: nobody waits for a log.
  LineLog(int file, LogLevel most) : file_(file), most_(most) {}

  void write(LogLevel level, std::string_view component, std::string_view text) EXCLUDES(mutex_);

 private:
  bool has_place() const;
  void put(const std::string& line) const;

  const int file_;
  const LogLevel most_;
  services::Mutex mutex_;
  std::uint64_t dropped_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::server
