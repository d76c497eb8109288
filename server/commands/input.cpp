#include "server/commands/input.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace race::server {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16U;

// As errno says.
tl::unexpected<Error> cannot_read() {
  return unexpected(ErrorCode::io, std::string("cannot be read: ") + std::strerror(errno));
}

Expected<std::string> read_all(int file) {
  std::string text;
  while (true) {
    const std::size_t size = text.size();
    text.resize(size + kBlock);
    const ssize_t got = ::read(file, text.data() + size, kBlock);
    if (got < 0 && errno != EINTR) return cannot_read();
    text.resize(size + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return text;
    if (text.size() > kMaxInput)
      return unexpected(ErrorCode::too_large, "has more than " + std::to_string(kMaxInput) + " bytes");
  }
}

}  // namespace

Expected<std::string> read_input(const std::string& file) {
  if (file == kStandardInput) return read_all(STDIN_FILENO);
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return cannot_read();
  auto text = read_all(opened);
  ::close(opened);
  return text;
}

}  // namespace race::server
