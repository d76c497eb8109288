#include "server/mcp/line_reader.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace race::server::mcp {
namespace {

// Of a file that does not wait by itself: who has its other end may have set that for both.
bool wait_for_input(int file) {
  pollfd input{file, POLLIN, 0};
  return ::poll(&input, 1, -1) > 0 || errno == EINTR;
}

}  // namespace

std::optional<Expected<std::string>> LineReader::next() {
  for (;;) {
    const std::size_t end = buffer_.find('\n', scanned_);
    const bool is_whole = end != std::string::npos;
    const std::size_t length = (is_whole ? end : buffer_.size()) - begin_;
    if (length > most_) too_long_ = true;
    if (is_whole || (ended_ && (length > 0 || too_long_))) {
      std::string line = take(is_whole ? end : buffer_.size());
      if (!std::exchange(too_long_, false)) return line;
      return unexpected(ErrorCode::too_large, "a message has at most " + std::to_string(most_) + " bytes");
    }
    if (ended_) return std::nullopt;
    if (too_long_) buffer_.clear();
    if (too_long_) begin_ = 0;
    scanned_ = buffer_.size();
    ended_ = !read_more();
  }
}

std::string LineReader::take(std::size_t end) {
  std::string line = too_long_ ? std::string() : buffer_.substr(begin_, end - begin_);
  begin_ = scanned_ = std::min(end + 1, buffer_.size());
  return line;
}

// What was taken goes first, so that the buffer holds one line and what one read gives.
bool LineReader::read_more() {
  std::array<char, std::size_t{64} * 1024> bytes;
  ssize_t count = 0;
  do count = ::read(file_, bytes.data(), bytes.size());
  while (count < 0 && (errno == EINTR || (errno == EAGAIN && wait_for_input(file_))));
  if (count <= 0) return false;
  buffer_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  return true;
}

}  // namespace race::server::mcp
