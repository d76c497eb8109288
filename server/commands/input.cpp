#include "server/commands/input.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "server/store/files.h"

namespace race::server {

Expected<std::string> read_input(const std::string& file) {
  if (file == kStandardInput) return read_open_file(STDIN_FILENO, kMaxInput);
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return unexpected(ErrorCode::io, std::string("cannot be read: ") + std::strerror(errno));
  auto text = read_open_file(opened, kMaxInput);
  ::close(opened);
  return text;
}

}  // namespace race::server
