// LineReader: lines of a file descriptor, of bounded length.
//
// Threads: one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/value/expected.h"

namespace race::server::mcp {

class LineReader {
 public:
  /// `most`: bytes of a line.
  LineReader(int file, std::size_t most) : file_(file), most_(most) {}

  /// The next line, without its end; what follows the last end is a line, too. Waits for it. Nothing: the file has
  /// ended, or cannot be read. Error `too_large`: the line is longer than `most`; it is passed over, and the next call
  /// gives the next line. No more than `most` and what one read gives is kept.
  std::optional<Expected<std::string>> next();

 private:
  bool read_more();
  std::string take(std::size_t end);

  const int file_;
  const std::size_t most_;
  std::string buffer_;
  std::size_t begin_ = 0;    // of the line in the buffer
  std::size_t scanned_ = 0;  // up to here there is no end of it
  bool too_long_ = false;    // it is being passed over
  bool ended_ = false;
};

}  // namespace race::server::mcp
